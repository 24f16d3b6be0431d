# make run, make test and make bench set up all they need themselves; nothing has to be installed before but Python.
PYTHON ?= python3
BIN := .venv/bin
EXAMPLE := resources/examples/arm.json

.PHONY: run test endurance fuzz translations bench setup qt clean

setup: .venv/installed

.venv/installed: pyproject.toml
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
	    { echo 'Python 3.11 or newer is needed; name it: make PYTHON=python3.12' >&2; exit 1; }
	@$(PYTHON) .ci/system_packages.py venv
	@test -x $(BIN)/python || $(PYTHON) -m venv .venv
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[test]'
	@touch $@

qt: setup
	@$(PYTHON) .ci/system_packages.py qt display

run: setup
	@if [ -n "$$DISPLAY$$WAYLAND_DISPLAY" ] || [ "$$(uname)" = Darwin ]; then \
	    $(MAKE) --no-print-directory qt && exec $(BIN)/python -m app; \
	else \
	    mkdir -p build && \
	    $(BIN)/starskel render $(EXAMPLE) --layout sheet -o build/arm.svg && \
	    $(BIN)/starskel render $(EXAMPLE) --layout sheet -o build/arm.eps && \
	    echo 'There is no display. The example blended by every method: build/arm.svg and build/arm.eps' && \
	    echo 'With a display (DISPLAY or WAYLAND_DISPLAY set) "make run" opens the editor.'; \
	fi

test: qt
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/mypy
	$(BIN)/lint-imports
	OPENBLAS_NUM_THREADS=1 $(BIN)/python -m pytest --numprocesses auto --dist worksteal

endurance: qt
	$(BIN)/python -m pytest -m endurance --endurance --durations=0

translations: setup
	$(BIN)/python .ci/translations.py

fuzz: setup
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[fuzz]'
	$(BIN)/python -m tests.fuzzing
	$(BIN)/python -m tests.fuzzing --atheris

bench: setup
	$(BIN)/python -m tests.benchmarks

clean:
	rm -rf .venv build dist .mypy_cache .ruff_cache .pytest_cache .import_linter_cache .hypothesis
