#!/bin/sh
# The shards of a run as a Slurm array: sbatch --array=1-16 array.sh SCENE.obj [options of solve]
# Shard I leaves shard-I.state here. A task that fails or is requeued goes on where its state was saved.
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --open-mode=append
shard=$SLURM_ARRAY_TASK_ID
exec multipath solve "$@" --shard "$shard/$SLURM_ARRAY_TASK_COUNT" --threads "$SLURM_CPUS_PER_TASK" \
    --state "shard-$shard.state" --resume --save-every "${SAVE_EVERY:-60s}" --quiet
