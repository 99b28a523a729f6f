#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes a Debian 12 machine ready and builds Interstice in build/release:
#   1. installs the packages that are missing (root or sudo),
#   2. fetches OpenFOAM's headers, which Debian has in a source package only,
#   3. configures and builds.
# What is done already is skipped. The headers are kept outside the repository, in
# ${INTERSTICE_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/interstice}, from where CMake takes them.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cache=${INTERSTICE_CACHE:-${XDG_CACHE_HOME:-${HOME:?is not set, so there is no place for the OpenFOAM headers}/.cache}/interstice}
headers=$cache/openfoam-v1912
log=$cache/setup.log

packages=(
    cmake make g++ bzip2
    openfoam libopenmpi-dev openmpi-bin liggghts libliggghts-dev
    libeigen3-dev nlohmann-json3-dev libgtest-dev libbenchmark-dev
    python3-matplotlib python3-numpy python3-scipy python3-yaml snakemake
)

say() { printf 'set-up: %s\n' "$*"; }

fail()
{
    printf 'set-up: %s\n' "$*" >&2
    exit 1
}

# Shows the end of the log before the sentence that says what to do.
failWithLog()
{
    tail -n 5 "$log" >&2
    fail "$* (all of it: $log)"
}

asRoot()
{
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    else
        sudo "$@"
    fi
}

missingPackages()
{
    local installed package
    installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${packages[@]}" 2>/dev/null |
        sed -n 's/^installed //p' || true)
    for package in "${packages[@]}"; do
        grep -qx -- "$package" <<<"$installed" || echo "$package"
    done
}

updatePackageLists()
{
    # A foreign source that fails is no reason to stop: what counts is whether ours can be had.
    asRoot apt-get -qq update </dev/null >>"$log" 2>&1 || true
}

installPackages()
{
    command -v dpkg-query >/dev/null ||
        fail "this machine is not Debian: build by hand with cmake, naming FOAM_SRC and FOAM_LIBBIN."

    local missing
    mapfile -t missing < <(missingPackages)
    [ ${#missing[@]} -gt 0 ] || return 0

    if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
        fail "missing packages: ${missing[*]}. Install them as root, or install sudo, and call again."
    fi
    say "installing Debian packages: ${missing[*]}"
    say "(from nothing, some minutes; details in $log)"
    updatePackageLists
    asRoot env DEBIAN_FRONTEND=noninteractive apt-get -qq -y --no-install-recommends \
        install "${missing[@]}" </dev/null >>"$log" 2>&1 ||
        fail "missing packages, which apt could not get (is the network there, do apt's sources name" \
            "Debian 12's main?): ${missing[*]}. Details: $log"
}

# The deb-src line that belongs to the deb line which offers OpenFOAM v1912, whatever file and
# format it is in. Written from what apt knows, so the machine's own sources stay untouched.
sourceEntry()
{
    local keyring=/usr/share/keyrings/debian-archive-keyring.gpg
    local options=
    [ ! -r "$keyring" ] || options="[signed-by=$keyring] "
    apt-cache madison openfoam |
        awk -F ' *[|] *' -v options="$options" '
            $2 ~ /^1912[.]/ && $3 ~ / Packages$/ {
                split($3, part, " ")
                split(part[2], suite, "/")
                print "deb-src " options part[1], suite[1], suite[2]
                exit
            }'
}

# Downloads the source package into $1 with apt, which checks signature and checksum.
downloadSource()
{
    local folder=$1 entry
    entry=$(sourceEntry)
    if [ -z "$entry" ]; then
        updatePackageLists
        entry=$(sourceEntry)
    fi
    [ -n "$entry" ] ||
        fail "missing: the OpenFOAM v1912 headers; no apt source of this machine offers openfoam 1912 (Debian 12, main)."

    mkdir -p "$folder/lists/partial" "$folder/archives/partial"
    printf '%s\n' "$entry" >"$folder/sources.list"
    local apt=(apt-get -qq
        -o "Dir::Etc::SourceList=$folder/sources.list" -o Dir::Etc::SourceParts=-
        -o "Dir::State::Lists=$folder/lists" -o "Dir::Cache::Archives=$folder/archives"
        -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache=
        -o "APT::Sandbox::User=$(id -un)")
    (
        cd "$folder"
        "${apt[@]}" update && "${apt[@]}" --download-only source openfoam
    ) </dev/null >>"$log" 2>&1 ||
        fail "missing: the OpenFOAM v1912 headers, whose source package (45 MB) could not be downloaded" \
            "(is the network there?). Details: $log"
}

fetchHeaders()
{
    [ ! -d "$headers" ] || return 0
    [ ! -e "${FOAM_SRC:-/nowhere}/OpenFOAM/lnInclude/Time.H" ] || return 0

    say "fetching OpenFOAM's headers (45 MB) into $headers"
    # Only a finished tree gets its name: what a kill leaves behind is thrown away here.
    rm -rf "$headers".partial
    mkdir -p "$headers".partial/download "$headers".partial/tree
    downloadSource "$headers".partial/download

    (
        cd "$headers".partial/tree
        tar -xjf ../download/openfoam_1912*.orig.tar.bz2 --strip-components=1 --wildcards \
            '*/src' '*/wmake' '*/META-INFO' '*/COPYING' --exclude='*/modules'
        PATH=$PWD/wmake:$PATH WM_PROJECT_DIR=$PWD wmake/wmakeLnIncludeAll src
    ) >>"$log" 2>&1 || failWithLog "OpenFOAM's source package could not be unpacked: is the disk full?"
    sync -f "$headers".partial
    mv "$headers".partial/tree "$headers"
    rm -rf "$headers".partial
}

build()
{
    cd "$root"
    local used
    used=$(sed -n 's/^FOAM_SRC:[A-Z]*=//p' build/release/CMakeCache.txt 2>/dev/null || true)
    # Afresh also if the headers it was configured with are gone or another user's.
    if [ ! -e build/release/Makefile ] || [ ! -r "$used/OpenFOAM/lnInclude/Time.H" ]; then
        say "configuring build/release"
        rm -rf build/release
        cmake --preset release >>"$log" 2>&1 </dev/null ||
            failWithLog "CMake could not configure build/release."
    fi
    say "building what is not up to date in build/release (the first time takes minutes)"
    # Of make's talk, only what it builds and what goes wrong.
    cmake --build --preset release --parallel "$(nproc)" -- --no-print-directory |
        grep -v '\] Built target\|^-- \|^Consolidate\|^Scanning' || [ "${PIPESTATUS[0]}" -eq 0 ] ||
        fail "the build failed: the compiler's message stands above."
}

mkdir -p "$cache"
exec 9>"$cache/lock"
flock -n 9 || { say "waiting for another set-up to end"; flock 9; }

: >"$log"
installPackages
fetchHeaders
build
