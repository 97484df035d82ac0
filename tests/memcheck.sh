# Runs every command under valgrind: no value is read before it is set, nothing outside of what was allocated, and nothing
# is lost. The work is small, since it takes some fifty times as long. Valgrind knows no AVX-512; the kernels choose AVX2.
# usage: memcheck.sh PROGRAM ROOT, in an empty folder
. "$2/tests/cli/check.sh"
few="--threads 2 -q --patches 100 -n 1000"

# Passes if the program ends with exit code 0 and valgrind has nothing to say.
clean() {
    valgrind -q --error-exitcode=99 --leak-check=full --show-leak-kinds=definite --errors-for-leak-kinds=definite \
        "$program" "$@" >out 2>err || {
        cat err
        return 1
    }
}

cp "$root"/scenes/5cubes.* "$root"/scenes/sphere.* .
for method in $(methods); do
    check "solve by $method" clean solve 5cubes.obj $few --method $method -o $method.csv
done
check "both sides" clean solve sphere.obj $few --two-sided -o sphere.csv
check "pictures and meshes" clean solve 5cubes.obj $few --size 24x18 --samples 1 -o a.png -o a.pfm -o a.ply -o a.glb -o a_lit.obj
check "a gathered picture" clean solve sphere.obj $few --size 12x9 --samples 1 --shading gather --gather-rays 2 -o g.ppm
for shard in 1 2; do
    check "a shard of two" clean solve 5cubes.obj $few --shard $shard/2 --state shard-$shard.state --save-every 0.01s
done
check "merge" clean merge shard-1.state shard-2.state --threads 2 -q -o merged.csv -o merged.state
check "render" clean render merged.state --threads 2 -q --size 24x18 --samples 1 -o merged.ppm
check "check" clean check 5cubes.obj --lines 1000 --threads 2
check "explain" clean explain 5cubes.obj -n 2 --of 500 --threads 2 -o lines.svg
check "compare" clean compare local.csv global.csv
check "points" clean points -d 4 -n 50 --discrepancy -o points.csv
check "study" clean study 5cubes.obj -q -m first-shot,reuse --from 256 --to 512 --replicates 2 --patches 50 --threads 2 -o study.svg
finish
