# A run in shards as a Slurm array, on a cluster of this one machine: both rounds of the method `reuse`, then a walk. One
# task of each is killed and requeued. The sums are compared with runs in one go.
# usage: slurm.sh PROGRAM ROOT         in an empty folder; as root, with slurm-wlm and munge
. "$2/tests/cli/check.sh"
here=$PWD
export SLURM_CONF="$here/slurm/slurm.conf"
SAVE_EVERY=0.001s
export SAVE_EVERY
trap 'sh "$root/tests/cluster/slurm_node.sh" stop "$here/slurm"' EXIT
if ! sh "$root/tests/cluster/slurm_node.sh" start "$here/slurm"; then
    echo "skipped: Slurm does not start here"
    echo "0 passed, 0 failed"
    exit
fi

# Stands before the program: the first run of shard 2 is killed as soon as its state is saved.
mkdir bin && cat >bin/multipath <<END
#!/bin/sh
case " \$* " in
*" --shard 2/"*)
    if [ -z "\$SLURM_RESTART_COUNT" ]; then
        "$program" "\$@" &
        until [ -f shard-2.state ]; do sleep 0.01; done
        kill -KILL \$!
        wait \$!
        exit 137
    fi
    echo "requeued, restart \$SLURM_RESTART_COUNT" >>requeued ;;
esac
exec "$program" "\$@"
END
chmod +x bin/multipath
PATH=$here/bin:$PATH
export PATH

# Submits the array, as the documentation says, and waits until all tasks are done.
# usage: array FOLDER TASKS ARGUMENTS...
array() {
    mkdir -p "$1" && cd "$1" || return
    tasks=$2
    shift 2
    job=$(sbatch --parsable --array="1-$tasks" "$root/tests/cluster/array.sh" "$@") || return
    while squeue -h -j "$job" 2>/dev/null | grep -q .; do
        for waiting in $(squeue -h -t PD -o "%i %r" | sed -n 's/ BeginTime$//p'); do
            scontrol update JobId="$waiting" StartTime=now # Slurm would wait two minutes before it runs a task again
        done
        sleep 0.5
    done
    cd "$here" || return
}

scene=$root/scenes/5cubes.obj
reuse="--lines 2^23 --patch-size 0.2"
requeued() { grep -q "restart 1" "$1/requeued"; }

first_round() { array counts 4 "$scene" $reuse && requeued counts && ends 0 merge counts/shard-?.state -o counted.state; }
check "the first round counts lines in four tasks, one of them killed and requeued" first_round

second_round() {
    array rays 4 "$scene" $reuse --from-state "$here/counted.state" && requeued rays &&
        ends 0 merge rays/shard-?.state --quiet -o merged.csv -o merged.png
}
check "the second round casts the rays" second_round

same() { ends 0 solve "$scene" $reuse --quiet -o whole.csv && cmp whole.csv merged.csv; }
check "the sum has the bytes of one run" same

walk() {
    array walks 4 "$scene" --method extended --lines 2^22 --patch-size 0.2 && requeued walks &&
        ends 0 merge walks/shard-?.state --quiet -o walk.csv && ends 0 compare walk.csv whole.csv --tolerance 5%
}
check "shards of a walk are averaged" walk
finish
