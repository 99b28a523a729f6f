#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# expectFailure.sh <text> <command...>: succeeds if the command ends with an error and has printed
# the text. ctest's WILL_FAIL would also take a program that is missing for the wanted failure.
set -uo pipefail
text=$1
shift

output=$("$@" 2>&1)
status=$?
printf '%s\n' "$output"
[ $status -ne 0 ] || { echo "The command ended with 0; an error is wanted." >&2; exit 1; }
grep -qF -- "$text" <<<"$output" || { echo "The output lacks: $text" >&2; exit 1; }
