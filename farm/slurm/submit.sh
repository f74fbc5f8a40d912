#!/bin/bash
# Hands the job in this folder over to Slurm: an array with a task for each part, and the merge, which waits for all of them; or an array with
# the frames of an animation. Once more after a failure: what is whole takes no time, the rest goes on. SBATCH_PARTITION, SBATCH_ACCOUNT and their like say where and how it runs.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")"
. ./job.env

mkdir -p parts log
tasks=$((TILES * RANGES))
[[ ${#FRAMES[@]} -eq 0 ]] || tasks=${#FRAMES[@]}
array=$(sbatch --parsable --array="0-$((tasks - 1))" eikonal.sbatch)
array=${array%%;*}
if [[ ${#FRAMES[@]} -gt 0 ]]; then
    echo "$tasks tasks: job $array; messages: $PWD/log"
    exit
fi
# Not afterok, which remembers the failure of a part that was put back and is whole now. The merge itself refuses to go without a part.
merge=$(sbatch --parsable --dependency="afterany:$array" merge.sbatch)
echo "$tasks parts: job $array; merge: job ${merge%%;*}; messages: $PWD/log"
