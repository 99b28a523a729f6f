#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What Snakemake asks of a job: running, success or failed. status.sh JOB
# The controller knows jobs that ended a few minutes ago; older ones are known where there is accounting.
# A job that nobody knows has ended, and whether its result is there tells how.
if said=$(scontrol show job "$1" 2>&1); then
    state=$(sed -n 's/.*JobState=\([A-Z_]*\).*/\1/p' <<< "$said" | head -n 1)
elif [[ $said == *"Invalid job id"* ]]; then
    state=$(sacct -j "$1" --format=State --noheader --parsable2 2>/dev/null | head -n 1)
    state=${state:-COMPLETED}
fi
case $state in
    COMPLETED) echo success ;;
    "" | PENDING | CONFIGURING | RUNNING | COMPLETING | SUSPENDED | REQUEUED) echo running ;;
    *) echo failed ;;
esac
