# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# To be sourced (bash): what Debian's OpenFOAM and Open MPI need, and our programs on the PATH.

export WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}

interstice_bin=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)/build/release/bin
case :$PATH: in
    *:"$interstice_bin":*) ;;
    *) export PATH=$interstice_bin:$PATH ;;
esac
unset interstice_bin

# More ranks than cores are slow but right.
export OMPI_MCA_rmaps_base_oversubscribe=1

# Open MPI refuses root, which is who one is in a container.
if [ "$(id -u)" -eq 0 ]; then
    export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi
