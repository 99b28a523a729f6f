#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs a build to an empty place and builds another solver against it:
#     installTest.sh BUILD WORK
set -euo pipefail
build=$1
work=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

rm -rf "$work"
cmake --install "$build" --prefix "$work/prefix" > /dev/null
cmake -S "$here/otherSolver" -B "$work/build" -DCMAKE_PREFIX_PATH="$work/prefix" > /dev/null
cmake --build "$work/build" > /dev/null
[ "$("$work/build/otherSolver")" = "GidaspowHuilin 1" ]

# The installed solver starts without the build: it misses a case, and says so.
"$work/prefix/bin/demPimpleFoam" -help | grep -q -- -parallel
[ -f "$work/prefix/share/interstice/liggghts_scripts/dieFilling.in" ]
