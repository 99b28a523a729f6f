# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# What the scripts that run a case have in common. They source it in the folder of the case, after `root`, the folder of
# Interstice, is known.

source "$root/cmake/environment.sh"

# readRanks DEFAULT [-np RANKS]: sets `ranks`
readRanks()
{
    ranks=$1
    shift
    [ $# -gt 0 ] || return 0
    [ $# -eq 2 ] && [ "$1" = -np ] && [[ $2 =~ ^[1-9][0-9]*$ ]] || usage
    ranks=$2
}

# A script that can do more has its own.
usage()
{
    echo "usage: $0 [-np RANKS]" >&2
    exit 2
}

# inLog NAME COMMAND...: screen output goes to log.NAME; the end of it is shown if the command fails.
inLog()
{
    local name=$1
    shift
    "$@" > "log.$name" 2>&1 || { tail -n 20 "log.$name" >&2; echo "$name failed: see $PWD/log.$name" >&2; exit 1; }
}

quietly()
{
    inLog "$1" "$@"
}

# What an earlier run left; what it was made from stays.
removeRun()
{
    rm -rf processor[0-9]* postProcessing VTK [1-9]* 0.[0-9]*
}

decompose()
{
    echo "numberOfSubdomains $ranks;" > system/ranks
    [ "$ranks" -eq 1 ] || quietly decomposePar -force
}

solve()
{
    if [ "$ranks" -gt 1 ]; then
        mpirun -np "$ranks" demPimpleFoam -parallel
    else
        demPimpleFoam
    fi
}

reconstruct()
{
    [ "$ranks" -eq 1 ] || quietly reconstructPar
}
