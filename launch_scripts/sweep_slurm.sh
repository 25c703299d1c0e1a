#!/usr/bin/env bash
# sweep_slurm.sh OUT.json SHARDS SUITE... [options of evaluate]: an evaluation as a job array on Slurm, merged into OUT.json.
#
# Every node has the program (packages, or BANDWAGON: its path) and sees the folder of OUT.json and the suites. A shard whose node is lost is queued
# again by Slurm; after anything else the same command goes on with the shards that are not complete. Options of the jobs: SBATCH_PARTITION,
# SBATCH_TIMELIMIT and the like.
set -euo pipefail

(($# >= 3)) || { sed -n '2s/^# //p' "$0" >&2 && exit 2; }
command -v sbatch >/dev/null || { echo "sbatch is not here: apt install slurm-client, or use sweep.sh" >&2 && exit 2; }
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=launch_scripts/shards.sh
. "$root/shards.sh"
begin_sweep "$@"

if ((${#left[@]} > 0)); then
  # --wait: until all have ended; its status is that of the worst.
  sbatch --wait --requeue --job-name=bandwagon --array="$(IFS=, && echo "${left[*]}")" --output="$shards/%a.log" \
    --wrap "$command --shard=\$SLURM_ARRAY_TASK_ID/$count --json=$(printf %q "$shards")/\$SLURM_ARRAY_TASK_ID.json" || true
fi
end_sweep
