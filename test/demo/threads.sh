#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# The number of threads changes no byte of any output.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

cp "$shipped" slivers.mesh.off

# same ARGUMENTS...: the files that these options name are equal with any number of threads.
same()
{
  local threads file
  expect 0 "$@" --threads 1
  mkdir -p one
  mv result* one
  for threads in 2 3 7 0; do
    if [ "$threads" = 0 ]; then expect 0 "$@"; else expect 0 "$@" --threads "$threads"; fi
    for file in one/*; do
      cmp "$file" "$(basename "$file")" || fail "$threads threads change $file of $*"
    done
    rm result*
  done
  rm -r one
}

same delaunay slivers.mesh.off -o result.ply --save result.save
same delaunay slivers.mesh.off -o result.ply --exact
same refine slivers.mesh.off -o result.ply --save result.save
same flatten slivers.mesh.off -o result.obj --matrix result.mtx
same simplify slivers.mesh.off -o result.ply --ratio 0.3 --prolongation result.mtx --save result.save
