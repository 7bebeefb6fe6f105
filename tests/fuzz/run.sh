#!/usr/bin/env bash
# Runs the fuzzers of a build folder, two at a time, and prints their results. Exit code 1 if one found something.
#   run.sh BUILD SECONDS [RUNS]    at most SECONDS and RUNS cases for each fuzzer
set -euo pipefail
build=$(realpath "$1")
cd "$(dirname "$0")"
seconds=$2
runs=${3:--1}
findings=$build/findings
logs=$build/fuzz-logs
mkdir -p "$findings" "$logs"

# run_one NAME MOST_BYTES FILE...: continues from the corpus of earlier runs in BUILD/corpus.
run_one() {
  local name=$1 most=$2
  shift 2
  mkdir -p "$build/corpus/$name"
  cp -- "$@" "$build/corpus/$name"
  local code=0
  "$build/fuzz_$name" -dict="$build/tests/fuzz/$name.dict" -max_len="$most" -max_total_time="$seconds" -runs="$runs" -timeout=10 \
    -rss_limit_mb=2048 -malloc_limit_mb=1024 -print_final_stats=1 -artifact_prefix="$findings/$name-" \
    "$build/corpus/$name" >"$logs/$name.log" 2>&1 || code=$?
  echo "$code" >"$logs/$name.code"
}

# The number after a word in the last line of the log that contains the word.
last() { grep -oE "$2 *[0-9]+" "$logs/$1.log" | tail -n 1 | grep -oE '[0-9]+$' || echo 0; }

rm -f "$logs"/*
while read -r -a target; do
  while [ "$(jobs -rp | wc -l)" -ge 2 ]; do wait -n || true; done
  echo "fuzzing ${target[0]}"
  run_one "${target[@]}" &
done <"$build/fuzzers.txt"
wait

total=0
failed=0
printf '\n%-16s %10s %8s %8s %8s  %s\n' target cases corpus cov: crashes code
while read -r name _; do
  cases=$(last "$name" 'stat::number_of_executed_units:')
  crashes=$(grep -c 'Test unit written' "$logs/$name.log" || true)
  code=$(cat "$logs/$name.code" 2>/dev/null || echo none)
  printf '%-16s %10d %8d %8d %8d  %s\n' "$name" "$cases" "$(last "$name" 'corp:')" "$(last "$name" 'cov:')" \
    "$crashes" "$code"
  total=$((total + cases))
  if [ "$code" != 0 ]; then
    failed=1
    grep -E 'ERROR: |SUMMARY: |broken invariant|runtime error|Test unit written' "$logs/$name.log" || true
  fi
done <"$build/fuzzers.txt"
echo "$total cases in total; findings in $findings"
exit "$failed"
