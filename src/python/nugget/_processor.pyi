# SPDX-License-Identifier: Apache-2.0
#: What this processor lacks of what the package is compiled for, and what to do; empty where it lacks nothing.
complaint: str
