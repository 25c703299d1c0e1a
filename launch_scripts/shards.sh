# What sweep.sh and sweep_slurm.sh share; read by them. Shards lie in OUT.json.shards until they are merged.
# shellcheck shell=bash disable=SC2034  # who reads this uses them

begin_sweep() { # OUT.json SHARDS SUITE... [options]; sets: out, count, shards, command, left
  out=$(realpath -m "$1")
  count=$2
  shift 2
  [[ $count =~ ^[1-9][0-9]*$ ]] || { echo "$count: must be a number of shards" >&2 && exit 2; }
  shards=$out.shards
  program=${BANDWAGON:-bandwagon}
  command -v "$program" >/dev/null || { echo "$program is not here: install the package, or set BANDWAGON" >&2 && exit 2; }
  command=$(printf '%q ' "$program" evaluate "$@")
  mkdir -p "$shards"
  find_left
  echo "$((count - ${#left[@]})) of $count shards are there"
}

find_left() {
  left=()
  local shard
  for ((shard = 1; shard <= count; ++shard)); do
    grep -qs '"complete": true' "$shards/$shard.json" || left+=("$shard")
  done
}

end_sweep() {
  find_left
  if ((${#left[@]} > 0)); then
    echo "not complete: shards ${left[*]} of $count; their last words are in $shards; the same command goes on" >&2
    exit 1
  fi
  local from=() shard
  for ((shard = 1; shard <= count; ++shard)); do from+=(--from "$shards/$shard.json"); done
  "$program" evaluate "${from[@]}" --json "$out"
  rm -r "$shards"
}
