#!/bin/bash
# Runs the job in this folder on this machine, with `openjd` of the Python package openjd-cli. A farm that reads Open Job Description takes
# eikonal.yaml with parameters.json, or for an animation frames.yaml with animation.json. Once more after a failure: what is whole takes no
# time, the rest goes on.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")"

[[ ! -e animation.json ]] || exec openjd run frames.yaml -p file://animation.json
exec openjd run eikonal.yaml -p file://parameters.json
