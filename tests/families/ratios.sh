#!/bin/sh
# The best ratio of local to global lines in families of rooms, and what (3) and a pilot lose, as rows of a Markdown table:
#   sh tests/families/ratios.sh PROGRAM FOLDER >ratios.md
# 64 lines for each patch, six executions. ratios.awk makes the table of docs/family.md of it. FOLDER keeps the finished executions.
set -e
here=$(cd "$(dirname "$0")" && pwd)
program=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
mkdir -p "$2" && cd "$2"

# rates NAME FAMILY SIZE PATCHES VARIABLES [OPTION ...]: VARIABLES are those of room.awk
rates() {
    name=$1 family=$2 size=$3 patches=$4 variables=$5
    shift 5
    file=$(echo "$name" | tr -c 'a-z0-9\n' -).obj
    awk -v family="$family" -v size="$size" $variables -v out="$file" -f "$here/room.awk"
    for sequence in random sobol; do
        "$program" study "$file" --patches "$patches" --methods first-shot,extended --sequences $sequence --ratios 1/16..16 \
            --to $((64 * patches)) --replicates 6 --cache cache "$@" 2>/dev/null |
            awk -v name="$name, $sequence" '
                /^(first-shot|extended),/ { method = $1; sub(",", "", method); best[method] = p[method] = three[method] = pilot[method] = paired[method] = "–" }
                /least error [0-9]/ { best[method] = $7 == "as" ? $6 " measured" : $6 " " $7 " " $8 " " $9; p[method] = $NF }
                / of \(3\):/ { three[method] = $4 ": " $7 " " $8 " " $9 " " $10 }
                / over pilot:/ { paired[method] = $4 " " $5 " " $6 " " $7 }
                / of pilot:/ { pilot[method] = $4 ": " $7 " " $8 " " $9 " " $10 }
                END { for (k = 1; k <= 2; ++k) { m = k == 1 ? "first-shot" : "extended"; printf "| %s, %s | %s | %s | %s | %s | %s |\n", name, m, best[m], p[m], three[m], pilot[m], paired[m] } }'
    done
}

echo "| room | least error at | p of the law | (3): error over the least | pilot | (3) over pilot |"
echo "| --- | --- | --- | --- | --- | --- |"
for white in 0.2 0.5 0.8 0.9; do
    rates "reflectance $white" furniture 20 2000 "-v white=$white"
done
rates "lamp turned up" furniture 20 2000 "-v up=1"
for patches in 200 20000; do
    rates "$patches patches" furniture 20 $patches ""
done
rates "9 rooms" building 9 2000 ""
rates "64 pillars" pillars 64 2000 ""
rates "open above" courtyard 20 2000 "" --sky 10
