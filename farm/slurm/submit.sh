#!/bin/bash
# Hands the job in this folder over to Slurm: an array with a task for each part, and the merge, which waits for all of them. Once more after a
# failure: parts that are whole take no time, others go on. SBATCH_PARTITION, SBATCH_ACCOUNT and their like say where and how it runs.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")"
. ./job.env

mkdir -p parts log
array=$(sbatch --parsable --array="0-$((TILES * RANGES - 1))" eikonal.sbatch)
array=${array%%;*}
# Not afterok, which remembers the failure of a part that was put back and is whole now. The merge itself refuses to go without a part.
merge=$(sbatch --parsable --dependency="afterany:$array" merge.sbatch)
echo "$((TILES * RANGES)) parts: job $array; merge: job ${merge%%;*}; messages: $PWD/log"
