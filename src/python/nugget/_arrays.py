# SPDX-License-Identifier: Apache-2.0
"""What the package calls an array."""
from typing import Any

from numpy.typing import NDArray

Array = NDArray[Any]
