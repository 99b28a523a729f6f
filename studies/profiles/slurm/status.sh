#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What Snakemake asks of a job: running, success or failed. status.sh JOB
state=$(sacct -j "$1" --format=State --noheader --parsable2 2>/dev/null | head -n 1)
case $state in
    COMPLETED) echo success ;;
    "" | PENDING | CONFIGURING | RUNNING | COMPLETING | SUSPENDED | REQUEUED) echo running ;;
    *) echo failed ;;
esac
