# Starts a Slurm cluster of this one machine, for tests: munged, slurmctld and slurmd, with everything they write in
# FOLDER. Needs Debian's or Ubuntu's slurm-wlm and munge, and root.
# usage: slurm_node.sh start|stop FOLDER      then: export SLURM_CONF=FOLDER/slurm.conf
folder=$2
[ "$folder" ] || { echo "usage: slurm_node.sh start|stop FOLDER" >&2; exit 2; }

configure() {
    mkdir -p "$folder/state" "$folder/spool" "$folder/log" || return
    cat >"$folder/slurm.conf" <<END
ClusterName=test
SlurmctldHost=$(hostname)(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/log/slurmctld.log
SlurmdLogFile=$folder/log/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
JobRequeue=1
RequeueExit=137
ReturnToService=2
MpiDefault=none
NodeName=$(hostname) NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=500 State=UNKNOWN
PartitionName=test Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
}

start() {
    configure || return
    mkdir -p /run/munge /var/log/munge && chown munge:munge /run/munge /var/log/munge 2>/dev/null
    [ -f /etc/munge/munge.key ] || { dd if=/dev/urandom of=/etc/munge/munge.key bs=1 count=1024 2>/dev/null &&
        chown munge:munge /etc/munge/munge.key && chmod 400 /etc/munge/munge.key; } || return
    pgrep -x munged >/dev/null || su -s /bin/sh munge -c "munged --force" 2>/dev/null ||
        setpriv --reuid=munge --regid=munge --clear-groups munged --force || return
    SLURM_CONF=$folder/slurm.conf
    export SLURM_CONF
    slurmctld -f "$SLURM_CONF" && slurmd -f "$SLURM_CONF" || return
    for wait in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
        sinfo -h -o %t 2>/dev/null | grep -q idle && return
        sleep 1
    done
    echo "the node did not become idle:"
    sinfo
    tail -n 20 "$folder"/log/*.log
    return 1
}

stop() {
    for daemon in slurmd slurmctld; do
        [ -f "$folder/$daemon.pid" ] && kill "$(cat "$folder/$daemon.pid")"
    done
    return 0
}

case $1 in
start | stop) "$1" ;;
*) echo "usage: slurm_node.sh start|stop FOLDER" >&2; exit 2 ;;
esac
