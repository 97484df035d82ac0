# `multipath compare`: how far one table of patches is from another.
. "$2/tests/cli/check.sh"
scene=$root/scenes/5cubes.obj
quick="--lines 4096 --patch-size 1 --quiet"
"$program" solve "$scene" $quick -o one.csv -o default.png --size 8x6 2>setup.log

# Mean radiosities 4.75 and 5; MSE (1 * 2^2 + 3 * 1^2) / 4 = 1.75, relative 1.75 / 5^2, shares 4/7 and 3/7.
columns=patch,surface,material,x,y,z,area,radiosity_r,radiosity_g,radiosity_b
printf '%s\n' $columns '0,0,"red, ""shiny""",1,2,3,1,10,10,10' 1,0,wall,4,5,6,3,3,3,3 >a.csv
printf '%s\n' $columns '0,0,"red, ""shiny""",1,2,3,1,8,8,8' 1,0,wall,4,5,6,3,4,4,4 >b.csv

by_hand() {
    ends 0 compare a.csv b.csv && silent err && lines_are out 5 && says out "2, 4 m^2" &&
        says out "1.75 W^2/m^4; relative 0.07, its root 26.46 %" &&
        says out "4.75 in A, 5 in B W/m^2: a difference of -5 %"
}
check "the report has the numbers that a hand computes" by_hand

# What another program writes: patches and radiosities, grey or in colour, with standard errors or without.
foreign() {
    printf 'patch,radiosity\n0,10\n1,3\n' >grey.csv && printf '# mine\nradiosity_b,patch,radiosity_r,radiosity_g\n10,0,10,10\n3,1,3,3\n' >colour.csv &&
        printf 'patch,radiosity,error_r,error_g,error_b\n0,10,.5,.5,.5\n1,3,.5,.5,.5\n' >errors.csv || return
    for table in grey colour; do
        ends 0 compare $table.csv b.csv && says out "1.75 W^2/m^4; relative 0.07, its root 26.46 %" || return
    done
    ends 0 compare errors.csv b.csv && says out "1.75 W^2/m^4" || return
    printf 'patch,radiosity\n0,10\n' >short.csv && ends 1 compare short.csv b.csv && says err "short.csv:1: 1 patches, expected 2 as in b.csv" &&
        ends 1 compare b.csv grey.csv && says err "grey.csv:1: no column" &&
        printf 'patch,radiosity\n1,10\n0,3\n' >order.csv && ends 1 compare order.csv b.csv && says err "patches are numbered from 0" &&
        printf 'patch,radiosity\n0,nan\n1,3\n' >nan.csv && ends 1 compare nan.csv b.csv && says err "nan.csv:2" &&
        printf 'patch,b\n0,1\n1,3\n' >none-named.csv && ends 1 compare none-named.csv b.csv && says err "radiosity_r"
}
check "a table of another program needs patches and radiosities alone" foreign

channels() {
    sed 's/3,3,3,3$/3,4,1,4/;s/10,10,10/8,8,8/' a.csv >green.csv
    ends 0 compare green.csv b.csv && says out " 2.25 W^2/m^4"
}
check "in colour the MSE is the mean over the channels" channels

identical() {
    ends 0 compare one.csv one.csv --tolerance 0 && silent err && says out "90, 70.3446 m^2" && says out "MSE        0 W"
}
check "a table is no distance from itself" identical

# Patch 5 is 1 m^2 of 70.3446398: MSE 0.5^2 / 3 / 70.3446398 = 1.18464e-3.
one_changed() {
    awk -F, -v OFS=, '$1 == 5 { $17 = sprintf("%.17g", $17 + 0.5) } 1' one.csv >changed.csv
    ends 0 compare changed.csv one.csv && says out "MSE        0.001185 W" &&
        ends 0 compare changed.csv one.csv --json && says out '"mean_square_error": 0.0011846'
}
check "one changed patch of a real table gives the MSE of its area" one_changed

json() {
    ends 0 compare a.csv b.csv --json && silent err && for line in '"result": "a.csv"' '"reference": "b.csv"' \
        '"patches": 2' '"area_m2": 4' '"mean_square_error": 1.75' '"relative_mean_square_error": 0.07' \
        '"mean_radiosity": 4.75' '"reference_mean_radiosity": 5'; do
        says out "$line" || return
    done
}
check "--json gives the same to programs" json

tolerance() {
    ends 0 compare a.csv b.csv --tolerance 27% && silent err && ends 0 compare a.csv b.csv --tolerance 0.2646 &&
        ends 1 compare a.csv b.csv --tolerance 26% && says out "MSE" && lines_are err 1 &&
        says err "a.csv differs by 26.46 % from b.csv, expected at most 26 %" &&
        ends 1 compare a.csv b.csv --tolerance 0 --json && says out '"mean_square_error": 1.75'
}
check "--tolerance decides the exit code, and nothing else does" tolerance

other_scene() {
    sed 's/^# scene: .*/# scene: 0000000000000000/' one.csv >other.csv
    ends 0 compare one.csv other.csv && lines_are err 1 && says err "warning: one.csv is of scene " &&
        says err "other.csv of scene 0000000000000000" && says out "MSE        0 W"
}
check "tables of another scene with the same patches are compared with a warning" other_scene

# usage: refused TEXT FILES...
refused() {
    text=$1
    shift
    ends 1 compare "$@" && silent out && lines_are err 1 && says err "$text"
}
check "tables of unequal length are not compared" refused "multipath: a.csv: 2 patches, expected 90 as in one.csv" a.csv one.csv

other_areas() {
    sed 's/6,3,3/6,3.000003,3/' a.csv >larger.csv && sed 's/6,3,3/6,3.000000000003,3/' a.csv >rounded.csv
    refused "larger.csv: patch 1 has 3.000003 m^2, expected 3 m^2 as in b.csv" larger.csv b.csv &&
        ends 0 compare rounded.csv b.csv && silent err
}
check "nor are patches of other areas, except for rounding" other_areas

check "a missing file is named" refused "none.csv: cannot be read" a.csv none.csv
check "a folder is no table" refused "Is a directory" . a.csv
check "a picture is no table" refused "default.png:2: control character" default.png a.csv
"$program" points --count 4 >points.csv
check "a table of points is none of patches" refused "points.csv:4: no column \`patch\`" points.csv a.csv
sed '3s/,3,3$//' a.csv >cut.csv
check "a row that is cut off is found" refused "cut.csv:3: row has 8 fields, expected 10 as in the header" cut.csv a.csv
sed 's/,[0-9]*,[0-9]*,[0-9]*$/,0,0,0/' b.csv >dark.csv
check "a dark reference is none" refused "dark.csv: mean radiosity is 0, expected a reference with light" a.csv dark.csv
dark_result() { ends 0 compare dark.csv b.csv && says out "a difference of -100 %"; }
check "a dark result is compared" dark_result
sed 's/10,10,10/1e200,0,0/' a.csv >huge.csv
check "numbers beyond all sense are refused" refused "huge.csv: numbers too large to compare with b.csv" huge.csv b.csv

# usage: wrong TEXT ARGS...
wrong() {
    text=$1
    shift
    ends 2 compare "$@" && silent out && says err "$text"
}
check "three are too many" wrong "b.csv" a.csv b.csv b.csv
check "a number of points that is none is refused" wrong "--points: expected a count" a.csv b.csv --points some
check "a tolerance that could mean two things is refused" wrong "--tolerance: expected a share" a.csv b.csv --tolerance 1

# Finer patches err less; what is shown is not the patches of the reference, but near the light that is gathered from it.
shown() {
    for size in 1 0.5 0.2; do
        "$program" solve "$scene" --patch-size $size --lines 2^15 --quiet -o size-$size.state || return
    done
    for size in 1 0.5; do
        ends 0 compare size-$size.state size-0.2.state --points 1000 --json || return
        sed -n 's/.*"relative_mean_square_error": \([-0-9.e]*\).*/\1/p' out >>shown_errors
    done
    awk 'NR == 1 { coarse = $1 } END { exit !(NR == 2 && coarse < 0.2 && $1 > 1e-4 && 2 * $1 < coarse) }' shown_errors ||
        { cat shown_errors; return 1; }
}
check "states with other patches are compared by what they show" shown

shown_as_asked() {
    ends 0 compare size-1.state size-0.2.state --points 500 --threads 1 && says out "of patches and noise together" &&
        mv out once && ends 0 compare size-1.state size-0.2.state --points 500 --threads 2 && cmp once out &&
        ends 1 compare size-1.state size-0.2.state --points 500 --tolerance 1% && says err "expected at most 1 %"
}
check "the same for any number of threads, and held to a tolerance" shown_as_asked

# Within a factor of two of what the finer solution tells.
alone() {
    ends 0 compare size-0.5.state --points 100 && says out "light gathered from A itself" &&
        ends 0 compare size-0.5.state --points 2000 --json || return
    sed -n 's/.*"relative_mean_square_error": \([-0-9.e]*\).*/\1/p' out >>shown_errors
    awk 'NR == 2 { known = $1 } END { exit !(NR == 3 && $1 < 2 * known && known < 2 * $1) }' shown_errors ||
        { cat shown_errors; return 1; }
}
check "a state alone tells about how far what it shows is from the truth" alone
check "a table alone is refused" refused "expected a state or a second result" a.csv
finish
