# iritx. Usual targets: all demo check check-san lint bench install dist clean
#   make help        lists them
#   CFG=release|debug|asan|hard|cov   build configuration (default release)
#   MOD=sym          only this floor's unit tests
#   CC=clang         another compiler (its objects are kept apart)
#   V=1              shows the commands
# Nothing below needs a change when a file is added: drop it in its folder.

.DEFAULT_GOAL := all
CFG     ?= release
PREFIX  ?= /usr/local
V       ?= 0
VERSION := $(shell cat VERSION)
SOVER   := $(firstword $(subst ., ,$(VERSION)))
CCNAME  := $(notdir $(firstword $(CC)))
B       := build/$(CFG)$(if $(filter cc gcc,$(CCNAME)),,-$(CCNAME))
Q       := $(if $(filter 1,$(V)),,@)

# --- packages ----------------------------------------------------------------
# Missing Debian packages are installed once, before anything else is looked at:
# make remakes this included stamp and starts again.
PACKAGES := build-essential pkg-config zlib1g-dev libxml2-dev liblzma-dev libxml2-utils libedit-dev libcmocka-dev libflint-dev libcairo2-dev libsundials-dev python3
PKGS     := zlib libxml-2.0
setup: build/.setup                                 ## install missing Debian packages
build/.setup: scripts/dev/setup Makefile
	@mkdir -p build; scripts/dev/setup $(PACKAGES) && touch $@
ifneq ($(filter-out clean help dist uninstall,$(or $(MAKECMDGOALS),all)),)
include build/.setup
endif

# --- flags -------------------------------------------------------------------
WARN := -Wall -Wextra -Wconversion -Wshadow -Wpedantic -Wstrict-prototypes \
        -Wmissing-prototypes -Wold-style-definition -Wwrite-strings -Wundef \
        -Wvla -Wpointer-arith -Wcast-qual -Wformat=2
# clang also counts the float constants NAN and INFINITY, which lose nothing.
WARN += $(if $(findstring clang,$(CCNAME)),,-Wdouble-promotion)
# No contraction: the same bits on every machine and in every build.
FLOAT := -ffp-contract=off -fno-fast-math
HARDEN := -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2 -fstack-protector-strong -fstack-clash-protection
OPT_release := -O2 -g -DNDEBUG $(HARDEN)
OPT_debug   := -O1 -g
OPT_asan    := -O1 -g -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all
OPT_hard    := $(OPT_asan) -DIX_HARDTEST
OPT_cov     := -O0 -g --coverage
ifeq ($(OPT_$(CFG)),)
$(error unknown CFG=$(CFG); use release, debug, asan, hard or cov)
endif
ALL_CFLAGS   = -std=c11 $(WARN) $(FLOAT) $(OPT_$(CFG)) -fPIC -pthread $(CFLAGS)
ALL_CPPFLAGS = $(if $(FLINT),-DIX_HAVE_FLINT) $(if $(filter 0,$(WITH_LIBEDIT)),-DIX_NO_LIBEDIT) $(if $(filter 0,$(WITH_SUNDIALS)),-DIX_NO_SUNDIALS) $(PKG_CPPFLAGS) -I$(B)/gen -I. -Iinclude -Isrc -Itests -Ibench -DIX_VERSION='"$(VERSION)"' -MMD -MP $(CPPFLAGS)
# WITH_LIBEDIT=0: a prompt without history and completion. The program loads
# the library with the first line that it asks for; only its header is needed.
WITH_LIBEDIT ?= 1
# WITH_SUNDIALS=0: no distances on surfaces. Loaded with the first of them.
WITH_SUNDIALS ?= 1
export WITH_SUNDIALS
# Exact arithmetic in tests only, as an independent truth; left out if absent.
FLINT       := $(shell printf '\043include <flint/fmpz_poly.h>\n' | $(CC) -E -x c - >/dev/null 2>&1 && echo 1)
TEST_LIBS   := -lcmocka $(if $(FLINT),-lflint -lgmp)
# As system headers: their warnings are not ours.
PKG_CPPFLAGS := $(patsubst -I%,-isystem %,$(shell pkg-config --cflags $(PKGS)))
# WITH_CAIRO=0 leaves the drawing module out.
WITH_CAIRO  ?= 1
export WITH_CAIRO
CAIRO       := $(if $(filter 1,$(WITH_CAIRO)),cairo)
LIBS         := $(shell pkg-config --libs $(PKGS)) -lm -pthread
LINK         = $(CC) $(OPT_$(CFG)) -Wl,-z,relro,-z,now $(LDFLAGS)

# --- files -------------------------------------------------------------------
LIB_SRC   := $(filter-out src/app/% src/draw/%,$(wildcard src/*/*.c irit_ext/ops/*.c))
DRAW_SRC  := $(if $(CAIRO),$(wildcard src/draw/*.c))
APP_SRC   := $(wildcard src/app/*.c)
HARNESS   := $(wildcard tests/harness/*.c)
TEST_SRC  := $(wildcard tests/unit/$(or $(MOD),*)/t_*.c)
BENCH_SRC := $(wildcard bench/b_*.c)
PUB_HDR   := $(wildcard include/iritx/*.h)
obj        = $(patsubst %.c,$(B)/%.o,$(1))
bin        = $(patsubst %.c,$(B)/%,$(1))
LIB       := $(B)/libiritx.a
SHLIB     := $(B)/libiritx.so
PROG      := $(if $(APP_SRC),$(B)/iritx)
MODULE    := $(if $(DRAW_SRC),$(B)/iritx_draw.so)
TESTS     := $(call bin,$(TEST_SRC))
ALL_OBJ   := $(call obj,$(DRAW_SRC) $(LIB_SRC) $(APP_SRC) $(TEST_SRC) $(HARNESS) $(BENCH_SRC))

.PHONY: all help setup demo check check-san coverage lint analyze bench install \
        uninstall dist clean format format-check FORCE
.SECONDARY: $(ALL_OBJ) $(TESTS) $(call bin,$(BENCH_SRC))
.DELETE_ON_ERROR:

all: $(LIB) $(SHLIB) $(PROG) $(MODULE) $(if $(filter 0,$(WITH_VIEWER)),,viewer) ## library and program (build/iritx)
	$(Q)$(if $(filter build/release,$(B)),$(if $(PROG),cmp -s $(PROG) build/iritx || cp -f $(PROG) build/iritx))
	$(Q)$(if $(filter build/release,$(B)),$(if $(MODULE),cp -f $(MODULE) build))

help:                                               ## this list
	@sed -n 's/^\([a-z-]*\):.*##  *\(.*\)/  \1\t\2/p' $(firstword $(MAKEFILE_LIST)) | expand -t18

# --- building ----------------------------------------------------------------
$(B)/.flags: FORCE
	@mkdir -p $(B); printf '%s\n' '$(CC) $(ALL_CFLAGS) $(ALL_CPPFLAGS)' | cmp -s - $@ || \
	 printf '%s\n' '$(CC) $(ALL_CFLAGS) $(ALL_CPPFLAGS)' > $@
$(B)/%.o: %.c $(B)/.flags
	@mkdir -p $(@D)
	@echo "  CC    $<"
	$(Q)$(CC) $(ALL_CPPFLAGS) $(ALL_CFLAGS) -c $< -o $@
# The schema of XML files, as numbers of bytes between the braces of an array.
$(B)/gen/iritx_rng.h: docs/iritx.rng
	@mkdir -p $(@D); od -An -v -tu1 $< | sed 's/[0-9][0-9]*/&,/g' > $@
$(call obj,src/io/xml_validate.c): $(B)/gen/iritx_rng.h
$(B)/.srcs: FORCE
	@mkdir -p $(B); echo $(LIB_SRC) | cmp -s - $@ || echo $(LIB_SRC) > $@
$(LIB): $(call obj,$(LIB_SRC)) $(B)/.srcs
	@echo "  AR    $@"
	$(Q)rm -f $@ && $(AR) rcs $@ $(filter %.o,$^)
$(SHLIB): $(call obj,$(LIB_SRC)) $(B)/.srcs src/exports
	@echo "  LD    $@"
	$(Q)$(LINK) -shared $(if $(findstring sanitize,$(OPT_$(CFG))),,-Wl,--no-undefined) \
	 -Wl,-soname,libiritx.so.$(SOVER) -Wl,--version-script,src/exports \
	 $(filter %.o,$^) $(LIBS) -o $@
# The drawing module, loaded when the first picture is drawn (src/draw/draw.h).
$(call obj,$(DRAW_SRC)): CPPFLAGS += $(patsubst -I%,-isystem %,$(shell pkg-config --cflags $(CAIRO)))
$(B)/iritx_draw.so: $(call obj,$(DRAW_SRC)) $(LIB)
	@echo "  LD    $@"
	$(Q)$(LINK) -shared -Wl,-Bsymbolic $(filter %.o %.a,$^) $(LIBS) $(shell pkg-config --libs $(CAIRO)) -o $@
# The whole library, and its public names shown to plug-ins.
$(B)/iritx: $(call obj,$(APP_SRC)) $(LIB) src/app/exports
	@echo "  LD    $@"
	$(Q)$(LINK) -Wl,--dynamic-list=src/app/exports $(filter %.o,$^) \
	 -Wl,--whole-archive $(LIB) -Wl,--no-whole-archive $(LIBS) -o $@
$(TESTS): %: %.o $(call obj,$(HARNESS)) $(LIB)
	$(Q)$(LINK) $^ $(LIBS) $(TEST_LIBS) -o $@
$(call bin,$(BENCH_SRC)): %: %.o $(LIB)
	$(Q)$(LINK) $^ $(LIBS) -o $@

# --- checking ----------------------------------------------------------------
# Each part ends with a line "N passed, N failed"; tests/harness/check adds up.
RUN_unit      = tests/unit/run $(TESTS)
RUN_selftest  = tests/script/selftest
RUN_script    = tests/script/run $(B)/iritx
RUN_golden    = tests/golden/run $(B)/iritx
RUN_reference = tests/reference/run $(B)/iritx
RUN_published = tests/published/run $(B)/iritx
RUN_roundtrip = tests/roundtrip/run $(B)/iritx
RUN_hostile   = tests/hostile/run $(B)/iritx
RUN_mutate    = tests/hostile/mutate $(B)/iritx
RUN_prompt    = WITH_LIBEDIT=$(WITH_LIBEDIT) tests/prompt/run $(B)/iritx
RUN_install   = CC='$(CC)' MAKE='$(MAKE)' tests/install/run
RUN_draw      = tests/draw/run $(B)/iritx
RUN_plugin    = CC='$(CC)' tests/plugin/run $(B)/iritx
RUN_ipc       = CC='$(CC)' tests/ipc/run $(B)/iritx
RUN_docs      = tests/docs/run $(B)/iritx
RUN_lint      = CC='$(CC)' CXX='$(CXX)' scripts/dev/lint $(LIB)
PARTS := unit selftest script golden reference published roundtrip hostile mutate prompt plugin ipc $(if $(MODULE),draw) \
         $(if $(filter release,$(CFG)),install) docs lint

check: all $(TESTS)                                 ## all tests; ends with "N passed, N failed"
	@tests/harness/check $(foreach p,$(PARTS),"$(RUN_$(p))")
check-san:                                          ## the same with address and undefined behaviour sanitizers
	@$(MAKE) --no-print-directory CFG=asan check
coverage:                                           ## lines and branches that "check" runs
	@$(MAKE) --no-print-directory CFG=cov CC=gcc check; scripts/dev/coverage build/cov
check-unit: $(TESTS)                                ## unit tests only (MOD=sym for one floor)
check-lint: $(LIB)                                  ## layers, headers, symbols, cited documents
check-selftest:
check-script check-golden check-reference check-published check-roundtrip check-hostile check-mutate check-prompt check-plugin check-ipc check-draw check-docs check-install: $(PROG) $(MODULE)
$(addprefix check-,$(PARTS)): check-%:
	@tests/harness/check "$(RUN_$*)"
.PHONY: $(addprefix check-,$(PARTS))

check-occt: $(PROG)                                 ## STEP files read by Open CASCADE, if installed
	@tests/occt/run $(B)/iritx
.PHONY: check-occt

FMT = $(shell find include src tests bench irit_ext -name '*.[ch]' 2>/dev/null)
lint: check-lint format-check analyze               ## check-lint, clang-format, clang-tidy, cppcheck
analyze:                                            ## clang-tidy and cppcheck, if installed
	@PKG_CPPFLAGS='-I$(B)/gen $(PKG_CPPFLAGS) $(shell pkg-config --cflags $(CAIRO) 2>/dev/null)' \
	 scripts/dev/analyze $(LIB_SRC) $(APP_SRC)
format:                                             ## rewrite the sources with clang-format
	clang-format -i $(FMT)
format-check:                                       ## do the sources look as clang-format wants?
	@if command -v clang-format >/dev/null; then clang-format --dry-run -Werror $(FMT); \
	 else echo "clang-format is not installed: skipped"; fi

bench: $(call bin,$(BENCH_SRC))                     ## timings, as one table
	@CC='$(CC)' bench/run $(B) $^

# --- using -------------------------------------------------------------------
demo: all                                           ## run scripts/demo.irt
	@scripts/dev/demo $(B)/iritx

# The viewer of "iritx view": an X3D browser in one script, made of an npm package
# that is fetched once. The build does without when there is no network, and asks
# again when told to ("make web"). WITH_VIEWER=0 leaves it out.
WITH_VIEWER  ?= 1
X_ITE        := 15.0.1
X_ITE_SHA512 := 199a625288853271e0f32e44f7a93963ba7bb461b503382a7d5548f5e5787f565d97667b1a2b991fa96dd19aaca5de25d91f7ad077ea1fec7182fe6130f7d772
WEB   := build/web/iritx_view.js
web: $(WEB)                                         ## the viewer for "iritx view", fetched again if need be
build/web/x_ite-$(X_ITE).tgz: scripts/dev/fetch_viewer
	$(Q)scripts/dev/fetch_viewer $(X_ITE) $(X_ITE_SHA512) $@
	$(Q)rm -f $(@D)/none
$(WEB): build/web/x_ite-$(X_ITE).tgz scripts/dev/bundle_viewer
	$(Q)rm -rf build/web/package && tar -xzf $< -C build/web && scripts/dev/bundle_viewer build/web/package $@
	$(Q)rm -rf build/web/package
viewer:
	@mkdir -p build/web; [ -e build/web/none ] || [ $(WEB) -nt scripts/dev/bundle_viewer ] || \
	 $(MAKE) --no-print-directory web 2>build/web/none && rm -f build/web/none || \
	 { sed -n 1p build/web/none; echo 'the viewer is left out, all else is built; "make web" tries again'; }
check-web: $(PROG)                                  ## the page of "iritx view" in headless Chromium, if installed
	@tests/harness/check "tests/web/run $(B)/iritx"
.PHONY: web viewer check-web

# --- installing --------------------------------------------------------------
D := $(DESTDIR)$(PREFIX)
FILL_IN := sed -e 's|@PREFIX@|$(PREFIX)|' -e 's|@VERSION@|$(VERSION)|' -e 's|@PKGS@|$(PKGS)|'
MAN     := $(notdir $(wildcard docs/man/*))
install: all                                        ## into PREFIX (/usr/local), below DESTDIR
	install -d $(D)/bin $(D)/lib/pkgconfig $(D)/include/iritx $(D)/share/iritx $(D)/share/doc/iritx
	install -m 644 $(PUB_HDR) $(D)/include/iritx
	install -m 644 $(LIB) $(D)/lib
	install -m 755 $(SHLIB) $(D)/lib/libiritx.so.$(VERSION)
	ln -sf libiritx.so.$(VERSION) $(D)/lib/libiritx.so.$(SOVER)
	ln -sf libiritx.so.$(SOVER) $(D)/lib/libiritx.so
	$(if $(PROG),install -m 755 $(PROG) $(D)/bin)
	$(if $(MODULE),install -d $(D)/lib/iritx && install -m 755 $(MODULE) $(D)/lib/iritx)
	$(FILL_IN) scripts/dev/iritx.pc.in > $(D)/lib/pkgconfig/iritx.pc
	cp -R README.md LICENSE CHANGELOG.md docs/. $(D)/share/doc/iritx && rm -rf $(D)/share/doc/iritx/man
	install -d $(addprefix $(D)/share/man/man,1 3) $(D)/share/bash-completion/completions
	for m in $(MAN); do $(FILL_IN) docs/man/$$m > $(D)/share/man/man$${m##*.}/$$m || exit 1; done
	install -m 644 scripts/completion/iritx.bash $(D)/share/bash-completion/completions/iritx
	[ ! -e $(WEB) ] || install -m 644 $(WEB) $(WEB:.js=.LICENSE) $(D)/share/iritx
	for f in scripts/*.irt irit_ext/*.irt; do [ ! -e "$$f" ] || install -m 644 "$$f" $(D)/share/iritx; done
uninstall:                                          ## remove what "install" put there
	rm -rf $(D)/include/iritx $(D)/share/iritx $(D)/share/doc/iritx $(D)/lib/pkgconfig/iritx.pc
	rm -f $(D)/bin/iritx $(D)/lib/libiritx.a $(D)/lib/libiritx.so $(D)/lib/libiritx.so.*
	rm -rf $(D)/lib/iritx
	for m in $(MAN); do rm -f $(D)/share/man/man$${m##*.}/$$m; done
	rm -f $(D)/share/bash-completion/completions/iritx
dist:                                               ## build/iritx-VERSION.tar.gz
	@mkdir -p build
	@if git rev-parse HEAD >/dev/null 2>&1; \
	 then git archive --prefix=iritx-$(VERSION)/ -o build/iritx-$(VERSION).tar.gz HEAD; \
	 else tar -czf build/iritx-$(VERSION).tar.gz --exclude=./build --transform='s,^\.,iritx-$(VERSION),' .; fi
	@echo build/iritx-$(VERSION).tar.gz
clean:                                              ## remove everything built
	rm -rf build

-include $(ALL_OBJ:.o=.d)
