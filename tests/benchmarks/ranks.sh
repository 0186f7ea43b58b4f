#!/usr/bin/env bash
# Measures the benefit of MPI ranks on this machine, as a table: seconds for the same work by 1, 2, 4, ... ranks with
# one thread each, interleaved, the median of three rounds; efficiency, messages, memory of rank 0.
#   tests/benchmarks/ranks.sh [BUILD]     default: build
# Uses up to as many ranks as there are processors, and then twice as many. Takes some minutes; nothing else should run
# meanwhile.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)
relief=$root/${1:-build}/bin/relief
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
rounds=3
processors=$(nproc)

ranks=(1)
while [ "${ranks[-1]}" -le "$processors" ]; do ranks+=($((ranks[-1] * 2))); done

# NAME COMMAND...: prints a row for each number of ranks.
# shellcheck disable=SC2094  # the name is only an argument
rows() {
    local name=$1 round count
    shift
    for ((round = 0; round < rounds; ++round)); do
        for count in "${ranks[@]}"; do
            rm -f "$scratch"/out.*
            # shellcheck disable=SC2016  # each rank's own number
            mpirun --oversubscribe --allow-run-as-root --bind-to none -n "$count" \
                bash -c 'exec /usr/bin/time -a -o "$0-$OMPI_COMM_WORLD_RANK" -f "%e %M" "$@"' \
                "$scratch/$name-$count" "$relief" "$@" 2>>"$scratch/$name-$count" >/dev/null
        done
    done
    local one=0 seconds messages memory
    for count in "${ranks[@]}"; do
        seconds=$(cut -d' ' -f1 "$scratch/$name-$count-0" | sort -n | sed -n "$((rounds / 2 + 1))p")
        memory=$(cut -d' ' -f2 "$scratch/$name-$count-0" | sort -n | tail -1)
        messages=$(sed -n 's/.* \([0-9]*\) messages$/\1/p' "$scratch/$name-$count" | tail -1)
        [ "$count" -gt 1 ] || one=$seconds
        awk -v name="$name" -v count="$count" -v one="$one" -v seconds="$seconds" -v messages="${messages:-0}" \
            -v memory="$memory" 'BEGIN {
                share = one / seconds / count
                for (n = 0.05; n < share; n += 0.1) bar = bar "█"
                printf "| %s | %d | %.1f | %.0f | %s | %d | %.0f |\n",
                    name, count, seconds, 100 * share, bar, messages, memory / 1024 }'
    done
}

printf '| work | ranks | seconds | efficiency, %% | | messages | rank 0, MB |\n| --- | --: | --: | --: | :-- | --: | --: |\n'
rows 'stress, 64 cases' stress --cases 64 --threads 1 --quiet
rows 'bench, 48 cells' bench tracers --relief bricks --relief hills --sizes 128 --seed 1,2,3,4,5,6 --elevations 60,25,10,random \
    --rays 50000 --rounds 2 --tracers exact,max-pyramid,layers --threads 1 -q -o "$scratch/out.csv"
rows 'picture, 640 x 480' render --relief city --size 640x480 --shadows --supersample 16 --threads 1 -q \
    -o "$scratch/out.png"
printf '\n(%s, %s processors, everything else stopped)\n' "$(sed -n 's/^model name[^:]*: //p;T;q' /proc/cpuinfo)" "$processors"
