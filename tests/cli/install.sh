# `make install`, `make uninstall` and `make dist`, in a copy of the sources. The program is the one under test; nothing is
# compiled.
. "$2/tests/cli/check.sh"
unset MAKEFLAGS MFLAGS MAKELEVEL BUILD CXX CXXFLAGS PREFIX DESTDIR

mkdir copy "with blanks" && (cd "$root" && cp -R LICENSE Makefile README.md docs scenes src tests "$OLDPWD/copy") || exit 1
here=$(pwd)
# Runs a target of the copy with the program as it is.
made() { make -s -C copy -o "$program" "PROGRAM=$program" "$@"; }
files_under() { (cd "$1" && find . -type f | sort); }
tree="$here/with blanks/tree"

installs() {
    made install "DESTDIR=$tree" PREFIX=/opt/multipath || return
    files_under "$tree/opt/multipath" >found
    { printf './%s\n' "bin/$(basename "$program")" share/man/man1/multipath.1 \
        share/doc/multipath/README.md share/doc/multipath/LICENSE
      (cd copy && find docs -type f | sed 's|^|./share/doc/multipath/|'; find scenes -type f | sed 's|^|./share/multipath/|')
    } | sort >expected
    diff expected found && [ "$(ls "$tree")" = opt ]
}
check "make install puts every file where it belongs, and no other" installs

# The folder of the sources has blanks in its name and may not be written.
elsewhere_without_git() {
    cp -R copy "with blanks/copy" && chmod -R a-w "with blanks/copy" || return
    set -- -s -C "with blanks/copy" BUILD="$here/objects"
    make "$@" "$here/objects/generated/viewer/page_files.inc" "$here/objects/generated/cli/sources_checksum.inc" && make "$@" dist
    result=$?
    chmod -R u+w "with blanks/copy" && [ $result -eq 0 ] && [ -s objects/generated/viewer/page_files.inc ] &&
        [ -s objects/multipath-*.gz ] && [ "$(ls objects | wc -l)" -eq 2 ]
}
check "make writes nothing among sources that are read-only, in a folder with blanks" elsewhere_without_git

blanks_in_build() { ! make -n -C copy "BUILD=$here/with blanks" >out 2>&1 && says out "has blanks in its name"; }
check "a folder of objects with blanks is refused" blanks_in_build

below_another_make() {
    printf 'all:\n\t+@$(MAKE) -n -C copy\n' >outer && make -s -j2 -f outer >out 2>err && says out "link    multipath" && silent err
}
check "another make may call it" below_another_make

# `install` of BSD has the options -c, -d and -m, before all operands. Other systems have no `nproc`.
other_tools() {
    mkdir tools && cat >tools/install <<END &&
#!/bin/sh
portable() {
    while getopts cdm: option; do [ "\$option" != "?" ] || return; done
    shift \$((OPTIND - 1))
    for operand; do case \$operand in -*) return 1 ;; esac; done
}
portable "\$@" && exec $(command -v install) "\$@"
END
        printf '#!/bin/sh\nexit 127\n' >tools/nproc && chmod +x tools/* &&
        PATH="$here/tools:$PATH" made install "DESTDIR=$here/bsd" PREFIX= && diff -r bsd "$tree/opt/multipath"
}
check "make install needs neither the options of GNU's install nor nproc" other_tools

for_everybody() { [ -x "$tree/opt/multipath/bin/$(basename "$program")" ] && [ -z "$(find "$tree" ! -perm -444)" ]; }
check "everybody may read what is installed" for_everybody

fresh_manual() { ends 0 help --man && cmp out "$tree/opt/multipath/share/man/man1/multipath.1"; }
check "the manual is that of the installed program" fresh_manual

runs_there() {
    (cd "$tree/opt/multipath" && "bin/$(basename "$program")" check share/multipath/scenes/cube.obj >"$here/out") && says out patches
}
check "the installed program reads the installed scenes" runs_there

# usage: found_by PROGRAM     in a folder without scenes; a file of the folder goes before a bundled scene of its name
found_by() {
    found_program=$1
    rm -rf elsewhere && mkdir elsewhere && (
        cd elsewhere || exit
        "$found_program" check cube --lines 1000 >check.out && grep -q '^/.*/scenes/cube.obj: ' check.out &&
            "$found_program" solve cube.obj --lines 1000 --quiet -o cube.csv &&
            "$found_program" explain cube -o cube.svg && ! "$found_program" check cube.mtl 2>/dev/null &&
            ! "$found_program" check ./cube 2>/dev/null && echo "no scene" >cube.obj &&
            ! "$found_program" check cube.obj 2>err && grep -q '^multipath: cube.obj: ' err
    )
}
# `paper` is ended as soon as it has read the first scene, or has failed.
paper_finds() {
    mkdir report && (cd report && exec "$tree/opt/multipath/bin/multipath" paper --quick -t 1) 2>err &
    until [ -d report/paper/cache ] || ! kill -0 $! 2>/dev/null; do sleep 0.1; done
    kill $! 2>/dev/null
    wait $!
    says err "] multipath study 5cubes" && [ -d report/paper/cache ]
}
bundled_scenes() {
    ln -sf "$tree/opt/multipath/bin/multipath" linked && found_by "$tree/opt/multipath/bin/multipath" && found_by "$here/linked" &&
        cp "$program" copy/multipath && found_by "$here/copy/multipath" && rm copy/multipath
}
[ -e /proc/self/exe ] && on_posix check "bundled scenes are found from any folder by their names" bundled_scenes
[ -e /proc/self/exe ] && on_posix check "paper finds them too" paper_finds

manual_is_found() {
    MANPATH="$tree/opt/multipath/share/man" man -w multipath >out && says out "$tree/opt/multipath/share/man/man1/multipath.1"
}
command -v man >/dev/null && check "man finds the manual" manual_is_found

old_files() {
    mkdir -p other/share/multipath/scenes other/bin && echo mine >other/share/multipath/scenes/mine.obj &&
        echo mine >other/bin/other && made install "DESTDIR=$here/other" PREFIX= &&
        made uninstall "DESTDIR=$here/other" PREFIX= && files_under other >found &&
        printf './%s\n' bin/other share/multipath/scenes/mine.obj | diff - found
}
check "make uninstall leaves the files of others" old_files

uninstalls() {
    made uninstall "DESTDIR=$tree" PREFIX=/opt/multipath && [ -z "$(find "$tree" -type f)" ] &&
        [ ! -e "$tree/opt/multipath/share/multipath" ] && [ ! -e "$tree/opt/multipath/share/doc/multipath" ]
}
check "make uninstall removes all that make install left, and the program's own folders" uninstalls

# Nobody may write there, not even root.
cannot_install() { ! made install DESTDIR=/dev/null >log 2>&1 && [ ! -e copy/bin ]; }
check "make install fails where it cannot write" cannot_install

# usage: packs_all_of FOLDER     `make dist` there packs what the copy holds, which can be made again from the archive
packs_all_of() {
    version=$("$program" --version | sed -n 's/^multipath //p')
    (cd "$1" && make -s dist) && rm -rf unpacked && mkdir unpacked &&
        tar -xzf "$1/build/multipath-$version.tar.gz" -C unpacked && [ "$(ls unpacked)" = "multipath-$version" ] || return
    mv "$1/build/multipath-$version.tar.gz" first.tar.gz
    files_under "unpacked/multipath-$version" >found
    (cd copy && find LICENSE Makefile README.md docs scenes src tests -type f | sed 's|^|./|' | sort) | diff - found &&
        (cd "unpacked/multipath-$version" && make -n UNITY=no) >commands && says commands "link    multipath" || return
    [ "$(grep -c '^echo "  compile' commands)" -eq "$(find copy/src -name '*.cpp' | wc -l)" ]
}
check "make dist packs all sources without git, under the version's name" packs_all_of copy

packs_what_is_committed() {
    cp -R copy repository && rm -rf repository/build && (
        cd repository && git init -q . && git add -A . && git -c user.name=a -c user.email=a@b commit -qm all &&
            echo "not committed" >src/loose.txt
    ) && packs_all_of repository
}
command -v git >/dev/null && check "make dist packs what is committed to git" packs_what_is_committed
finish
