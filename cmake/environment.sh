# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# To be sourced (bash): what Debian's OpenFOAM and Open MPI need, and our programs on the PATH.

export WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}

# Where a case that lies elsewhere finds what all cases share.
INTERSTICE_ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
export INTERSTICE_ROOT
case :$PATH: in
    *:"$INTERSTICE_ROOT/build/release/bin":*) ;;
    *) export PATH=$INTERSTICE_ROOT/build/release/bin:$PATH ;;
esac

# More ranks than cores are slow but right.
export OMPI_MCA_rmaps_base_oversubscribe=1

# Open MPI refuses root, which is who one is in a container.
if [ "$(id -u)" -eq 0 ]; then
    export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi
