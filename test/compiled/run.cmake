# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Runs `program` and writes what it prints to the file `output`.
execute_process(COMMAND "${program}" OUTPUT_FILE "${output}" COMMAND_ERROR_IS_FATAL ANY)
