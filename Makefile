# Everything runs in a virtual environment, .venv unless VENV says otherwise. `make help` lists the targets.
PYTHON ?= $(shell command -v python3.11 || command -v python3)
VENV ?= .venv
BIN := $(VENV)/bin
READY := $(VENV)/.rpg-installed
# Tests start rpg hundreds of times: without the compiled modules each start would compile all of them anew.
unexport PYTHONDONTWRITEBYTECODE
# mypy shares its work among all cores.
export MYPY_NUM_WORKERS ?= auto
INSTRUCTION ?= Stack two green blocks on the blue patch and spell the word CAT in front of it

.DEFAULT_GOAL := help
.PHONY: help setup demo test check format schemas docs library bench bench-others corpus kills clean

help: ## list the targets
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-12s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

setup: $(READY) ## make the virtual environment and install rpg with what its tests need

$(READY): pyproject.toml
	@test -x $(BIN)/python || $(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[dev]'
	@touch $@

demo: setup ## compile an instruction (INSTRUCTION="...") into a verified task under tasks/
	$(BIN)/rpg compile "$(INSTRUCTION)"

test: setup ## run all tests
	$(BIN)/pytest --numprocesses auto --dist loadfile --no-loadscope-reorder

check: setup ## lint, formatting, types, architecture
	$(BIN)/ruff check src tests benchmarks
	$(BIN)/ruff format --check src tests benchmarks
	$(BIN)/mypy
	$(BIN)/pytest tests/project/test_architecture.py tests/project/test_generated.py tests/project/test_words.py

format: setup ## format the code and mend what the linter can
	$(BIN)/ruff check --fix src tests benchmarks
	$(BIN)/ruff format src tests benchmarks

schemas: setup ## export the JSON Schemas to schemas/
	$(BIN)/python docs/generate.py

docs: setup ## write the generated pages of docs/
	$(BIN)/python docs/generate.py

library: setup ## build the reference tasks of library/ anew
	$(BIN)/python -m rpg.library

bench: setup ## measure speed, each figure beside its floor
	$(BIN)/python benchmarks/bench.py
	$(BIN)/python -m benchmarks.corpus
	$(BIN)/python benchmarks/batches.py

bench-memory: setup ## compile 10,000 instructions in one process and watch its memory
	$(BIN)/python benchmarks/memory.py

bench-resume: setup ## kill a batch at 50 random moments; it resumes to the same bytes
	$(BIN)/python benchmarks/resuming.py

bench-sleep: setup ## whether sleeping bodies and threads would help the gates, and change no verdict
	$(BIN)/python benchmarks/sleeping.py
	$(BIN)/python benchmarks/threads.py

bench-others: setup ## measure other simulators' stacking tasks; OTHERS names the Python that has them
	@test -n "$(OTHERS)" || { printf '%s\n' \
	  'robosuite, dm_control and gymnasium-robotics need an older MuJoCo, in an environment of their own:' \
	  '  python3.11 -m venv .venv-others' \
	  '  .venv-others/bin/pip install mujoco==3.3.7 robosuite==1.5.2 dm_control==1.0.34 gymnasium-robotics==1.4.2' \
	  '  make bench-others OTHERS=.venv-others/bin/python'; exit 2; }
	OURS=$(BIN)/python $(OTHERS) benchmarks/others.py

upgrade: setup ## verify a workspace that another MuJoCo built; OTHER names a Python with rpg and that MuJoCo
	@test -n "$(OTHER)" || { printf '%s\n' \
	  'another MuJoCo needs an environment of its own:' \
	  '  python3.11 -m venv .venv-other' \
	  '  .venv-other/bin/pip install mujoco==3.5.0 --editable .' \
	  '  make upgrade OTHER=.venv-other/bin/python'; exit 2; }
	OTHER_PYTHON=$(abspath $(OTHER)) $(BIN)/pytest tests/batch/test_two_versions.py

corpus: setup ## report how the corpus of instructions and the sessions of edits fare: right, refused, wrong
	$(BIN)/python -m tests.corpus.run
	$(BIN)/python -m tests.steer.run

kills: setup ## kill compile, steer and session 200 times each; no finished version may be lost
	$(BIN)/python -m tests.steer.kills --times 200

clean: ## remove what was built, but no tasks
	rm -rf $(VENV) build dist .pytest_cache .mypy_cache .ruff_cache .hypothesis
