#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# install.sh: installs the Debian packages of the current directory with apt, and uses them. Is meant for
# a bare system, see scripts/check_release.sh.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/use.sh"

! dpkg-query -s libcgal-dev >/dev/null 2>&1 || fail "this is no bare system: libcgal-dev is installed"
apt-get update
DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends g++ cmake ninja-build ./*.deb
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
use_packages /usr "$work"
(cd "$work" && python3 -c "import intrinsic")
echo "packages: $(dpkg-query -W -f '${Package} ${Version}, ' '*intrinsic*') are installed and work"
