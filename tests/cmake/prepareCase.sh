#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# prepareCase.sh <case> <copy> <ranks> <x|y|z>: copies a case folder, meshes it, and decomposes it
# into equal slices along one direction. The logs of the utilities go to the copy.
set -euo pipefail
source=$1 copy=$2 ranks=$3 direction=$4

rm -rf "$copy"
mkdir -p "$(dirname "$copy")"
cp -R "$source" "$copy"
cd "$copy"

blockMesh >log.blockMesh 2>&1 || { cat log.blockMesh; exit 1; }
[ "$ranks" -gt 1 ] || exit 0

case $direction in
    x) slices="$ranks 1 1" ;;
    y) slices="1 $ranks 1" ;;
    z) slices="1 1 $ranks" ;;
    *) echo "The direction of slices is '$direction'; x, y or z is wanted." >&2; exit 1 ;;
esac
cat >system/decomposeParDict <<EOF
FoamFile { version 2.0; format ascii; class dictionary; object decomposeParDict; }
numberOfSubdomains $ranks;
method simple;
simpleCoeffs { n ($slices); delta 0.001; }
EOF
decomposePar >log.decomposePar 2>&1 || { cat log.decomposePar; exit 1; }
