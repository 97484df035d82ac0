# make            builds ./multipath
# make demo       solves the bundled scene 5CUBES and leaves 5cubes.png and 5cubes.ppm beside the program
# make test       builds and runs the tests, except
# make long-tests those that take long: statistics, every option at its limits, interrupts, installation
# make sweep      judges random scenes of every kind, SEEDS=1-1000, or files, OBJ=FOLDER, by every method against particles
# make coverage   tells which lines of src/ the tests run, folder by folder; with g++, whose gcov counts them
# make mutants    plants the bugs of tests/mutants.list one by one and tells which the tests notice; takes about an hour
# make bench      measures speed; close other programs first. OBJ=FILE.obj: of lines through this file
# make paper      computes the paper's tables and figures again: build/paper/index.html, in six minutes on two processors
# make results    the same, and puts them into docs/results.md and docs/results
# make pictures   runs the commands of the gallery and of the lectures, docs/{gallery,method,beyond}.md, and renews their pictures and numbers
# make install    puts program, manual, scenes and documents under PREFIX (/usr/local), or DESTDIR/PREFIX
# make uninstall  removes what make install put there
# make dist       packs the sources, of git what is committed, into build/multipath-VERSION.tar.gz
# make dist-windows  packs program, scenes and documents for Windows into a .zip there, by WINDOWS_CXX
# make lab        makes the laboratory, build/lab.html: the program in a page of a browser; needs Emscripten (em++)
# make clean      removes what make made
# CXX, CXXFLAGS, BUILD (folder of the objects), TESTS (folder of compiled tests, which are used as they are) and DOCTEST
# (folder that holds doctest/doctest.h) may be set; V=1 shows the commands, WERROR=-Werror makes warnings errors.
# The files of a folder are compiled as one; UNITY=no compiles every file by itself, which takes longer from scratch and less
# after a change.

OPTIMISE  = -O3
CXXFLAGS ?= $(OPTIMISE)
BUILD    ?= build
$(if $(word 2,$(BUILD)),$(error BUILD: the folder '$(BUILD)' has blanks in its name; expected one without))
# FreeBSD has c++, not g++.
ifeq ($(origin CXX)$(shell command -v g++ 2>/dev/null),default)
CXX := c++
endif
triple   := $(shell $(CXX) -dumpmachine 2>/dev/null)
windows  := $(findstring mingw,$(triple))$(findstring windows,$(triple))
exe      := $(if $(windows),.exe)
pthread  ?= -pthread
here     := $(if $(filter build,$(BUILD)),,$(BUILD)/)
PROGRAM  ?= $(here)multipath$(exe)
run       = $(if $(windows),$(if $(filter Windows_NT,$(OS)),,wine)) "$(abspath $(PROGRAM))"
# Where addresses have 32 bits, every count of 64 bits that numbers something would be warned of. On ARM, g++ would tell of
# each call that is passed otherwise than before version 10.
WARNINGS  = -Wall -Wextra -Wpedantic -Wshadow -Wno-psabi $(if $(WERROR),-Wconversion $(WERROR))
# The processor's stack of 80-bit numbers rounds otherwise than all other processors.
machine  := $(if $(filter i386-% i486-% i586-% i686-%,$(triple)),-msse2 -mfpmath=sse)
# For Windows: names of files in UTF-8, by the program's manifest; no libraries beside the program. There g++ takes formats for
# those of the system's printf.
ifneq ($(windows),)
WARNINGS += -Wno-format
LDFLAGS  += -static
# g++ takes the stack of Windows for more aligned than it is (GCC bug 54412), unless its distribution has changed that.
unaligned := -Wa,-muse-unaligned-vector-move
machine  += $(if $(shell echo | $(CXX) -Wa,--help -c -x assembler - 2>/dev/null | grep muse-unaligned-vector),$(unaligned))
manifest := $(BUILD)/src/base/platform/windows.res
WINDRES  ?= $(shell for name in $(firstword $(subst -g++, ,$(CXX)))-windres windres x86_64-w64-mingw32-windres; do \
                command -v $$name && break; done)
endif
# Contracted multiply-adds and reassociated sums would make results depend on the compiler.
COMPILE   = $(CXX) -std=c++17 $(WARNINGS) $(CXXFLAGS) $(machine) -ffp-contract=off -fno-math-errno $(pthread) -MMD -MP \
            -iquote . -Isrc -I$(BUILD)/generated

Q         = $(if $(V),,@)

sources      = $(sort $(shell find src -name '*.cpp'))
test_sources = $(sort $(shell find tests -name '*.cpp' ! -path 'tests/bench/*' ! -path 'tests/fuzz/*'))

# Compiled by themselves: kernels, whose lanes have the same names in each of them, and the version, which any change changes.
alone      = $(filter src/main.cpp src/cli/version.cpp %kernel.cpp,$(sources))
folders    = $(patsubst %/,%,$(sort $(dir $1)))
units      = $(if $(filter no,$(UNITY)),$(sources:%.cpp=%),$(call folders,$(filter-out $(alone),$(sources))) $(alone:%.cpp=%))
test_units = $(if $(filter no,$(UNITY)),$(test_sources:%.cpp=%),$(call folders,$(test_sources)))
objects      = $(units:%=$(BUILD)/%.o)
test_objects = $(test_units:%=$(or $(TESTS),$(BUILD))/%.o)

# Not below another make, which has its own.
ifeq ($(filter -j% --jobserver%,$(MAKEFLAGS))$(filter-out 0,$(MAKELEVEL)),)
MAKEFLAGS += -j$(shell nproc 2>/dev/null || getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)
endif

$(PROGRAM): $(objects) $(manifest)
	@echo "  link    $@"
	$(Q)$(CXX) $(CXXFLAGS) $(pthread) $^ $(LDFLAGS) -o $@

$(manifest): src/base/platform/windows.rc src/base/platform/windows.manifest
	@mkdir -p $(@D)
	$(Q)$(WINDRES) -O coff -o $@ $<

demo: $(PROGRAM)
	$(run) solve scenes/5cubes.obj --lines 2^22 -o $(here)5cubes.png -o $(here)5cubes.ppm

paper: $(PROGRAM)
	$(run) paper -o $(BUILD)/paper

results: paper
	@mkdir -p docs/results
	cp $(BUILD)/paper/*.svg $(BUILD)/paper/*.png docs/results
	sed -f docs/builders/results.sed $(BUILD)/paper/index.html > docs/results.md

pictures: $(PROGRAM)
	BUILD=$(BUILD) RENEW=yes sh tests/documented_commands.sh $(PROGRAM) docs/gallery.md docs/method.md docs/beyond.md

test long-tests: $(BUILD)/unit_tests$(exe) $(PROGRAM)
	@sh tests/run.sh $(BUILD)/unit_tests$(exe) $(PROGRAM) $(BUILD) $(if $(filter long-tests,$@),long,quick)

parts_tested = $(filter-out $(BUILD)/src/main.o,$(objects))

$(BUILD)/unit_tests$(exe): $(parts_tested) $(test_objects)
	@echo "  link    $@"
	$(Q)$(CXX) $(CXXFLAGS) $(pthread) $(parts_tested) $(test_objects) $(LDFLAGS) -o $@

$(test_objects): COMPILE += -Itests $(addprefix -isystem ,$(shell cat $(BUILD)/doctest.path 2>/dev/null))
$(test_objects): | $(BUILD)/doctest.path

$(BUILD)/doctest.path: tests/find_doctest.sh
	@mkdir -p $(@D)
	@CXX="$(CXX)" DOCTEST="$(DOCTEST)" sh tests/find_doctest.sh $(BUILD) > $@.new
	@mv $@.new $@

# The viewer's page with its style sheet and scripts in it, and its lines as string literals.
page_with_parts = $(BUILD)/generated/viewer/page.html

$(filter $(BUILD)/src/viewer%,$(objects)): $(BUILD)/generated/viewer/page_files.inc

$(page_with_parts): src/viewer/page.awk $(wildcard src/viewer/page/*)
	@mkdir -p $(@D)
	@cd src/viewer/page && awk -f ../page.awk page.html > "$(abspath $@.new)"
	@mv $@.new $@

$(BUILD)/generated/viewer/page_files.inc: $(page_with_parts)
	@sed 's/[\"]/\\&/g; s/.*/"&\\n",/' $< > $@.new
	@mv $@.new $@

# The checksum of all sources, by which a program knows that kept results are those of another one.
$(BUILD)/src/cli/version.o: $(BUILD)/generated/cli/sources_checksum.inc

$(BUILD)/generated/cli/sources_checksum.inc: $(sort $(shell find src -type f))
	@mkdir -p $(@D)
	@cat $^ | { cksum || md5sum || echo unknown; } 2>/dev/null | sed 's/.*/"&"/' > $@.new
	@mv $@.new $@

# -O3 for the folders where lines fly, -O1 for what runs for each surface or pixel; the others and the tests compile faster.
of_folders = $(filter $(foreach folder,$1,$(BUILD)/src/$(folder).o $(BUILD)/src/$(folder)/%),$(objects))
$(objects) $(test_objects): OPTIMISE = -Og
$(call of_folders,scene image): OPTIMISE = -O1
$(call of_folders,base parallel sampling geometry transport radiosity scene/texture): OPTIMISE = -O3

define compile
@mkdir -p $(@D)
@echo "  compile $(<:$(BUILD)/unity/%.cpp=%)"
$(Q)$(COMPILE) -c $< -o $@
endef

$(BUILD)/%.o: %.cpp
	$(compile)

$(BUILD)/%.o: $(BUILD)/unity/%.cpp
	$(compile)

# Written again only when the folder's list of files has changed.
.PRECIOUS: $(BUILD)/unity/%.cpp
$(BUILD)/unity/%.cpp: always
	@mkdir -p $(@D)
	@printf '#include "%s"\n' $(filter-out $(alone),$(wildcard $*/*.cpp)) > $@.new
	@if cmp -s $@.new $@; then rm $@.new; else mv $@.new $@; fi

sweep: $(BUILD)/unit_tests$(exe)
	SEEDS="$(SEEDS)" OBJ="$(OBJ)" $(BUILD)/unit_tests$(exe) -ts=sweep

coverage:
	+@BUILD="$(BUILD)" CXX="$(CXX)" sh tests/coverage.sh

mutants: $(BUILD)/unit_tests $(PROGRAM)
	+@UNITY=no sh tests/mutants.sh $(BUILD) $(PROGRAM)

bench: $(BUILD)/bench
	"$(abspath $(BUILD))/bench" $(OBJ)

# Compared with Embree if its headers are there.
bench_objects = $(patsubst %.cpp,$(BUILD)/%.o,$(wildcard tests/bench/*.cpp))
embree        = $(firstword $(foreach v,4 3,$(if $(wildcard /usr/include/embree$(v)/rtcore.h),$(v))))

$(BUILD)/bench: $(bench_objects) $(filter-out $(BUILD)/src/main.o,$(objects))
	@echo "  link    $@"
	$(Q)$(CXX) $(CXXFLAGS) $(pthread) $^ $(addprefix -lembree,$(embree)) -o $@

$(bench_objects): COMPILE += -Itests/bench $(addprefix -DEMBREE_VERSION=,$(embree))

# tests/fuzz/run.sh builds these by clang++, which brings the fuzzer's main.
fuzz_objects = $(patsubst %.cpp,$(BUILD)/%.o,$(wildcard tests/fuzz/*.cpp))

$(BUILD)/%_fuzz: $(BUILD)/tests/fuzz/%_fuzz.o $(filter-out $(BUILD)/src/main.o,$(objects))
	@echo "  link    $@"
	$(Q)$(CXX) $(CXXFLAGS) -fsanitize=fuzzer $(pthread) $^ -o $@

PREFIX    ?= /usr/local
place      = "$(DESTDIR)$(PREFIX)"
documents  = README.md LICENSE $(sort $(shell find docs -type f))
own        = $(patsubst %,share/multipath/%,$(sort $(shell find scenes -type f))) $(documents:%=share/doc/multipath/%)
lab_page   = $(wildcard $(BUILD)/lab.html)
installed  = bin/$(notdir $(PROGRAM)) share/man/man1/multipath.1 $(own) $(lab_page:%=share/doc/multipath/lab.html)

# The manual is the program's own: it writes it from the tables that it reads its options by.
install: $(PROGRAM)
	@for folder in $(sort $(dir $(installed))); do install -d $(place)/$$folder || exit; done
	install -m 755 $(PROGRAM) $(place)/bin/
	$(run) help --man > $(place)/share/man/man1/multipath.1
	@chmod 644 $(place)/share/man/man1/multipath.1
	@for file in $(own); do install -m 644 $${file#share/*multipath/} $(place)/$$file || exit; done
	@$(if $(lab_page),install -m 644 $(lab_page) $(place)/share/doc/multipath/lab.html)

uninstall:
	@for file in $(installed); do rm -f $(place)/$$file || exit; done
	@for folder in $$(printf '%s\n' $(dir $(own)) share/doc/multipath share/multipath | sort -ru); do \
	    rmdir $(place)/$$folder 2>/dev/null || true; done

version  = $(shell sed -n 's/.*return "multipath \([0-9.]*\)".*/\1/p' src/cli/version.cpp)
archive  = multipath-$(version)
packed   = $(wildcard .ci .clang-format .clang-tidy .gitignore) LICENSE Makefile README.md docs scenes src tests

dist:
	@mkdir -p $(BUILD)
	@if [ -e .git ]; then git archive -o $(BUILD)/$(archive).tar.gz --prefix=$(archive)/ HEAD; else \
	    rm -rf $(BUILD)/$(archive) && mkdir $(BUILD)/$(archive) && cp -R $(packed) $(BUILD)/$(archive) && \
	    chmod -R u+w $(BUILD)/$(archive) && tar -czf $(BUILD)/$(archive).tar.gz -C $(BUILD) $(archive) && rm -r $(BUILD)/$(archive); fi
	@echo $(BUILD)/$(archive).tar.gz

WINDOWS_CXX ?= $(if $(windows),$(CXX),x86_64-w64-mingw32-g++-posix)

dist-windows:
	@for tool in $(WINDOWS_CXX) zip; do command -v $$tool >/dev/null || \
	    { echo "dist-windows: $$tool is missing; expected it, as in the packages zip and g++-mingw-w64-x86-64-posix" >&2; exit 2; }; done
	+@$(MAKE) CXX=$(WINDOWS_CXX) BUILD=$(BUILD)/windows PROGRAM=$(BUILD)/windows/multipath.exe
	@cd $(BUILD) && rm -rf $(archive) $(archive)-windows.zip && mkdir $(archive) && cp windows/multipath.exe $(archive)
	@cp -R LICENSE README.md docs scenes $(BUILD)/$(archive)
	@cd $(BUILD) && zip -qr $(archive)-windows.zip $(archive) && rm -r $(archive)
	@echo $(BUILD)/$(archive)-windows.zip

# The laboratory: the program as WebAssembly in a page. Debian's Emscripten looks for its modules of node where NODE_PATH says.
LAB_CXX ?= em++
lab_made = $(BUILD)/lab/multipath.js

lab:
	@command -v $(LAB_CXX) >/dev/null || \
	    { echo "lab: $(LAB_CXX) is missing; expected Emscripten, as in the package emscripten" >&2; exit 2; }
	+@NODE_PATH=$${NODE_PATH:-/usr/share/nodejs} $(MAKE) CXX=$(LAB_CXX) pthread= BUILD=$(BUILD)/lab PROGRAM=$(lab_made) \
	    CXXFLAGS='$$(subst -Og,-Os,$$(OPTIMISE)) -msimd128 -fwasm-exceptions' \
	    LDFLAGS='-sALLOW_MEMORY_GROWTH -sMODULARIZE -sEXPORT_NAME=Multipath -sINVOKE_RUN=0 -sFORCE_FILESYSTEM -sEXIT_RUNTIME \
	    -sENVIRONMENT=worker -sEXPORTED_RUNTIME_METHODS=FS,callMain' $(lab_made)
	@sh src/lab/page.sh $(BUILD)/lab > $(BUILD)/lab.html.new && mv $(BUILD)/lab.html.new $(BUILD)/lab.html
	@echo $(BUILD)/lab.html

clean:
	rm -rf $(BUILD) $(PROGRAM) 5cubes.png 5cubes.ppm

.PHONY: always demo paper results pictures test long-tests sweep coverage mutants bench install uninstall dist dist-windows lab clean
$(BUILD)/%.d: ;
-include $(objects:.o=.d) $(test_objects:.o=.d) $(bench_objects:.o=.d) $(fuzz_objects:.o=.d)
