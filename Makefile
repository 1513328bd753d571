# iritx. Usual targets: all demo check check-san lint bench install dist clean
#   make help        lists them
#   CFG=release|debug|asan|hard|cov   build configuration (default release)
#   MOD=sym          only this floor's unit tests in "check-unit"
#   CC=clang         another compiler (its objects are kept apart)
# Nothing below needs a change when a file is added: drop it in its folder.

CFG     ?= release
PREFIX  ?= /usr/local
V       ?= 0
VERSION := $(shell cat VERSION)
CCNAME  := $(notdir $(firstword $(CC)))
B       := build/$(CFG)$(if $(filter cc gcc,$(CCNAME)),,-$(CCNAME))
Q       := $(if $(filter 1,$(V)),,@)

# --- packages ----------------------------------------------------------------
PACKAGES := build-essential pkg-config zlib1g-dev libcmocka-dev python3
PKGS     := zlib

WARN := -Wall -Wextra -Wconversion -Wshadow -Wpedantic -Wstrict-prototypes \
        -Wmissing-prototypes -Wold-style-definition -Wwrite-strings -Wundef \
        -Wdouble-promotion -Wvla -Wpointer-arith -Wcast-qual -Wformat=2
# No contraction: the same bits on every machine and in every build.
FLOAT := -ffp-contract=off -fno-fast-math
OPT_release := -O2 -g -DNDEBUG
OPT_debug   := -O1 -g
OPT_asan    := -O1 -g -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all
OPT_hard    := $(OPT_asan) -DIX_HARDTEST
OPT_cov     := -O0 -g --coverage
ifeq ($(OPT_$(CFG)),)
$(error unknown CFG=$(CFG); use release, debug, asan, hard or cov)
endif
ALL_CFLAGS   = -std=c11 $(WARN) $(FLOAT) $(OPT_$(CFG)) -fPIC -pthread $(CFLAGS)
ALL_CPPFLAGS = -Iinclude -Isrc -Itests -DIX_VERSION='"$(VERSION)"' -MMD -MP $(CPPFLAGS)
LIBS         = $(shell pkg-config --libs $(PKGS)) -lm -pthread
LINK         = $(CC) $(OPT_$(CFG)) $(LDFLAGS)

LIB_SRC   := $(filter-out src/app/%,$(wildcard src/*/*.c))
APP_SRC   := $(wildcard src/app/*.c)
HARNESS   := $(wildcard tests/harness/*.c)
TEST_SRC  := $(wildcard tests/unit/$(or $(MOD),*)/t_*.c)
BENCH_SRC := $(wildcard bench/b_*.c)
PUB_HDR   := $(wildcard include/iritx/*.h)
obj        = $(patsubst %.c,$(B)/%.o,$(1))
bin        = $(patsubst %.c,$(B)/%,$(1))
LIB       := $(B)/libiritx.a
SHLIB     := $(B)/libiritx.so
PROG      := $(B)/iritx
ALL_OBJ   := $(call obj,$(LIB_SRC) $(APP_SRC) $(TEST_SRC) $(HARNESS) $(BENCH_SRC))

.PHONY: all help setup demo check check-unit check-script check-san lint check-layers \
        check-headers check-symbols bench install uninstall dist clean format format-check FORCE
.SECONDARY: $(ALL_OBJ) $(call bin,$(TEST_SRC) $(BENCH_SRC))
.DELETE_ON_ERROR:

all: setup $(LIB) $(SHLIB) $(PROG)                  ## library and program (build/iritx)
	$(Q)$(if $(filter build/release,$(B)),cp -f $(PROG) build/iritx)

help:                                               ## this list
	@sed -n 's/^\([a-z-]*\):.*##  *\(.*\)/  \1\t\2/p' $(firstword $(MAKEFILE_LIST)) | expand -t18

# Missing Debian packages are installed once; the stamp names what was checked.
setup: build/.setup                                 ## install missing Debian packages
build/.setup: scripts/dev/setup Makefile
	@mkdir -p build; scripts/dev/setup $(PACKAGES); touch $@

$(B)/.flags: FORCE
	@mkdir -p $(B); printf '%s\n' '$(CC) $(ALL_CFLAGS) $(ALL_CPPFLAGS)' | cmp -s - $@ || \
	 printf '%s\n' '$(CC) $(ALL_CFLAGS) $(ALL_CPPFLAGS)' > $@
$(B)/%.o: %.c $(B)/.flags | build/.setup
	@mkdir -p $(@D)
	@echo "  CC    $<"
	$(Q)$(CC) $(ALL_CPPFLAGS) $(ALL_CFLAGS) -c $< -o $@
$(B)/.srcs: FORCE
	@mkdir -p $(B); echo $(LIB_SRC) | cmp -s - $@ || echo $(LIB_SRC) > $@
$(LIB): $(call obj,$(LIB_SRC)) $(B)/.srcs
	@echo "  AR    $@"
	$(Q)rm -f $@ && $(AR) rcs $@ $(filter %.o,$^)
$(SHLIB): $(call obj,$(LIB_SRC)) $(B)/.srcs
	@echo "  LD    $@"
	$(Q)$(LINK) -shared -Wl,-soname,libiritx.so.0 $(filter %.o,$^) $(LIBS) -o $@
$(PROG): $(call obj,$(APP_SRC)) $(LIB)
	@echo "  LD    $@"
	$(Q)$(LINK) $^ $(LIBS) -o $@
$(call bin,$(TEST_SRC)): %: %.o $(call obj,$(HARNESS)) $(LIB)
	$(Q)$(LINK) $^ $(LIBS) -lcmocka -o $@
$(call bin,$(BENCH_SRC)): %: %.o $(LIB)
	$(Q)$(LINK) $^ $(LIBS) -o $@

clean:                                              ## remove everything built
	rm -rf build

-include $(ALL_OBJ:.o=.d)
