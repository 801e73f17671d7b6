#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# pip.sh: installs the package for Python by the commands of the README, and runs the example of the
# README. Then installs it again without build isolation. Is meant for a bare system, run as root:
#   scripts/check_release.sh trixie test/packages/pip.sh
set -euo pipefail
export DEBIAN_FRONTEND=noninteractive

# Stands for sudo, which a bare system has not.
sudo()
{
  [[ $1 == apt-get ]] || return 1
  apt-get -y "${@:2}"
}

section=$(sed -n '/^## Python/,/^## Beside/p' README.md)
example=$(sed -n '/^```python/,/^```/p' <<<"$section" | grep -v '^```')
apt-get update
eval "$(sed -n 's/^    //p' <<<"$section")"
run_example()
{
  (cd / && "$OLDPWD/env/bin/python" -c "$example"$'\nprint(len(V), pieces.uv.shape, P.shape)')
}
run_example
env/bin/pip install --no-build-isolation --force-reinstall --no-deps .
run_example
echo "pip: $(env/bin/pip list 2>/dev/null | grep intrinsic) is installed and works"
