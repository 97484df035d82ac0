# make            builds ./multipath
# make demo       solves the bundled scene 5CUBES and leaves 5cubes.png and 5cubes.ppm here
# make test       builds and runs all tests
# make bench      measures speed; close other programs first
# make paper      computes the paper's tables and figures again: build/paper/index.html, in ten minutes on two processors
# make results    the same, and puts them into docs/results.md and docs/results
# make gallery    runs the commands of docs/gallery.md, which makes its pictures again
# make clean      removes what make made
# CXX, CXXFLAGS, BUILD (folder of the objects) and DOCTEST (folder that holds doctest/doctest.h) may be set; V=1 shows
# the commands.

CXXFLAGS ?= -O3
BUILD    ?= build
PROGRAM  ?= $(if $(filter build,$(BUILD)),multipath,$(BUILD)/multipath)
WARNINGS  = -Wall -Wextra -Wpedantic -Wshadow -Wconversion
# Contracted multiply-adds and reassociated sums would make results depend on the compiler.
COMPILE   = $(CXX) -std=c++17 $(WARNINGS) $(CXXFLAGS) -ffp-contract=off -fno-math-errno -pthread -MMD -MP -Isrc

Q         = $(if $(V),,@)

sources      = $(wildcard src/*.cpp src/*/*.cpp)
objects      = $(sources:%.cpp=$(BUILD)/%.o)
test_sources = $(filter-out tests/bench/% tests/fuzz/%,$(wildcard tests/*.cpp tests/*/*.cpp))
test_objects = $(test_sources:%.cpp=$(BUILD)/%.o)

ifeq ($(filter -j% --jobserver%,$(MAKEFLAGS)),)
MAKEFLAGS += -j$(shell nproc 2>/dev/null || echo 2)
endif

$(PROGRAM): $(objects)
	@echo "  link    $@"
	$(Q)$(CXX) $(CXXFLAGS) -pthread $^ -o $@

demo: $(PROGRAM)
	./$(PROGRAM) solve scenes/5cubes.obj --lines 2^22 -o 5cubes.png -o 5cubes.ppm

paper: $(PROGRAM)
	./$(PROGRAM) paper -o $(BUILD)/paper

results: paper
	@mkdir -p docs/results
	cp $(BUILD)/paper/*.svg $(BUILD)/paper/*.png docs/results
	sed 's/^!\[\([^]]*\)\](/&results\//' $(BUILD)/paper/results.md > docs/results.md

gallery: multipath
	@mkdir -p docs/gallery
	sed -n '/^```sh$$/,/^```$$/p' docs/gallery.md | grep -v '^```' | sh -ex

test: $(BUILD)/unit_tests $(PROGRAM)
	@sh tests/run.sh $(BUILD)/unit_tests $(PROGRAM) $(BUILD)

$(BUILD)/unit_tests: $(test_objects) $(filter-out $(BUILD)/src/main.o,$(objects))
	@echo "  link    $@"
	$(Q)$(CXX) $(CXXFLAGS) -pthread $^ -o $@

$(test_objects): COMPILE += -Itests $(addprefix -isystem ,$(shell cat $(BUILD)/doctest.path 2>/dev/null))
$(test_objects): | $(BUILD)/doctest.path

$(BUILD)/doctest.path: tests/find_doctest.sh
	@mkdir -p $(@D)
	@CXX="$(CXX)" DOCTEST="$(DOCTEST)" sh tests/find_doctest.sh $(BUILD) > $@.new
	@mv $@.new $@

# The files of the viewer's page as string literals: {"name", "line\n" "line\n" ...}, for each.
page_files = $(wildcard src/viewer/page/*)

$(BUILD)/src/viewer/page_files.o: COMPILE += -I$(BUILD)/generated
$(BUILD)/src/viewer/page_files.o: $(BUILD)/generated/viewer/page_files.inc

$(BUILD)/generated/viewer/page_files.inc: $(page_files)
	@mkdir -p $(@D)
	@for file in $(page_files); do \
	    echo "{\"$${file##*/}\","; sed 's/[\"]/\\&/g; s/.*/"&\\n"/' "$$file"; echo "},"; \
	done > $@.new
	@mv $@.new $@

$(BUILD)/%.o: %.cpp
	@mkdir -p $(@D)
	@echo "  compile $<"
	$(Q)$(COMPILE) -c $< -o $@

bench: $(BUILD)/bench
	./$(BUILD)/bench

# Compared with Embree if its headers are there.
bench_objects = $(patsubst %.cpp,$(BUILD)/%.o,$(wildcard tests/bench/*.cpp))
embree        = $(firstword $(foreach v,4 3,$(if $(wildcard /usr/include/embree$(v)/rtcore.h),$(v))))

$(BUILD)/bench: $(bench_objects) $(filter-out $(BUILD)/src/main.o,$(objects))
	@echo "  link    $@"
	$(Q)$(CXX) $(CXXFLAGS) -pthread $^ $(addprefix -lembree,$(embree)) -o $@

$(bench_objects): COMPILE += -Itests/bench $(addprefix -DEMBREE_VERSION=,$(embree))

# tests/fuzz/run.sh builds these by clang++, which brings the fuzzer's main.
fuzz_objects = $(patsubst %.cpp,$(BUILD)/%.o,$(wildcard tests/fuzz/*.cpp))

$(BUILD)/%_fuzz: $(BUILD)/tests/fuzz/%_fuzz.o $(filter-out $(BUILD)/src/main.o,$(objects))
	@echo "  link    $@"
	$(Q)$(CXX) $(CXXFLAGS) -fsanitize=fuzzer -pthread $^ -o $@

clean:
	rm -rf $(BUILD) $(PROGRAM) 5cubes.png 5cubes.ppm

.PHONY: demo paper results gallery test bench clean
-include $(objects:.o=.d) $(test_objects:.o=.d) $(bench_objects:.o=.d) $(fuzz_objects:.o=.d)
