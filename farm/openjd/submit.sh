#!/bin/bash
# Runs the job in this folder on this machine, with `openjd` of the Python package openjd-cli. A farm that reads Open Job Description takes
# eikonal.yaml with parameters.json. Once more after a failure: parts that are whole take no time, others go on.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")"

exec openjd run eikonal.yaml -p file://parameters.json
