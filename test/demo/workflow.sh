#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# The workflow over many meshes: how each run ends is a row, whatever it is. Without Snakemake only the
# steps are tested, without matplotlib no report is drawn.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"
workflow=$tests/../../benchmark/workflow

# A program that does as it is named instead of what it should.
for what in hangs:'exec sleep 60' loops:'while :; do :; done' crashes:'kill -SEGV $$' fails:'echo no >&2; exit 1'; do
  printf '#!/bin/sh\n%s\n' "${what#*:}" >"${what%%:*}"
  chmod +x "${what%%:*}"
done

mkdir -p runs/{delaunay,hangs,loops,crashes,fails}
run() { python3 "$workflow/run.py" "$1" "$2.mesh.off" "runs/$3/$2.json" 0.5 delaunay -o OUT.ply || fail "run.py $*"; }
"$program" --version >out
for mesh in good polygon bow_tie; do
  run "$program" $mesh delaunay
done
for what in hangs loops crashes fails; do
  run "./$what" good $what
done
python3 "$workflow/table.py" runs table.csv
rows=$(cut -d, -f1-4 table.csv | tr '\n' ' ')
[ "$rows" = 'mesh,command,outcome,vertices good.mesh.off,crashes,crash, bow_tie.mesh.off,delaunay,refused, '`
  `'good.mesh.off,delaunay,success,4 polygon.mesh.off,delaunay,success,4 good.mesh.off,fails,failure, '`
  `'good.mesh.off,hangs,timeout, good.mesh.off,loops,timeout, ' ] || fail "the table is: $rows"
grep -q 'bow_tie.*non-manifold vertex' table.csv || fail 'why a mesh is refused'

if python3 -c 'import matplotlib' 2>err; then
  python3 "$workflow/report.py" table.csv report.html
  grep -q '4 runs that failed' report.html || fail 'the report'
fi
