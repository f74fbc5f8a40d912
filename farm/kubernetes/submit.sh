#!/bin/bash
# Hands the job in this folder over to Kubernetes.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")"

exec kubectl apply -k .
