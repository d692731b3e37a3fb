#!/bin/bash
# A benchmark as a job array: each task runs its part, all into one folder.
#   OUT=FOLDER CONFIG=FILE SVOSCOPE=build/svoscope sbatch --array=1-4 assets/bench/slurm.sh
# The report, once all are done:
#   sbatch --dependency=afterok:JOBID --wrap "build/svoscope bench --report --out FOLDER"
#SBATCH --job-name=svoscope-bench
#SBATCH --cpus-per-task=2
#SBATCH --output=svoscope-bench-%A-%a.log
set -eu
exec "$SVOSCOPE" bench "$CONFIG" --out "$OUT" --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT"
