# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What Placode raises. Everything is a PlacodeError, and also what Python would expect of it."""


class PlacodeError(Exception):
    """Anything that Placode refuses or cannot do."""


class BadArgument(PlacodeError, ValueError):
    """Wrong shape, not a number, out of range."""


class BadDefinition(PlacodeError, ValueError):
    """A task, a scene or changes of it that cannot be used."""


class NotReset(PlacodeError, RuntimeError):
    """Nothing has begun: call reset first."""


class Ended(PlacodeError, RuntimeError):
    """The attempt is over: call reset first."""


class Running(PlacodeError, RuntimeError):
    """The attempt is not over yet."""


class OtherTask(PlacodeError, ValueError):
    """A saved moment of another task."""


class NoPicture(PlacodeError, RuntimeError):
    """There is no OpenGL to draw a picture with."""


class FileProblem(PlacodeError, OSError):
    """A file that exists already or cannot be written."""


class NoMemory(PlacodeError, MemoryError):
    """There is not enough memory."""


# By placode_status of placode.h.
_BY_STATUS = {1: BadArgument, 2: BadDefinition, 3: NotReset, 4: Ended, 5: Running, 6: OtherTask,
              7: NoPicture, 8: FileProblem, 9: NoMemory}


def of_status(status, words):
    """The exception for a status of placode.h."""
    return _BY_STATUS.get(status, PlacodeError)(words)
