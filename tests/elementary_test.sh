# C libraries round exp, sin, hypot ... differently, so results would depend on the system: src calls those of
# base/elementary.h, which round alike everywhere. Only the square root and rounding to whole numbers are the same in all.
# usage: elementary_test.sh PROGRAM ROOT, in a folder of its own
. "$2/tests/cli/check.sh"

library='exp|exp2|expm1|log|log2|log10|log1p|pow|sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|cbrt|hypot|erf|erfc|tgamma|lgamma'

# usage: calls SRC      the calls of these functions of the C library, but for those in base/elementary.cpp
calls() {
    find "$1" -type f \( -name '*.h' -o -name '*.cpp' -o -name '*.inl' \) ! -path '*/base/elementary.*' \
        -exec grep -nE "(std::|^|[^A-Za-z0-9_:.>])($library)\(" {} + | grep -vE '^[^:]*:[0-9]*: *//|elementary::'
}
none() { ! calls "$root/src"; }
check "no elementary function of the C library is called" none

planted() { mkdir src && echo "double a = std::hypot(b, c) + $1(d);" >src/a.cpp && [ "$(calls src | wc -l)" -eq 1 ]; }
check "a call would be found" planted sin
finish
