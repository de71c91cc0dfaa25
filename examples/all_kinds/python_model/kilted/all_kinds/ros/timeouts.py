# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Time-outs and periods of the node, in seconds."""

# For subscribers to receive what was published last; Fast DDS 3.2 may take 3 s to acknowledge.
ACKNOWLEDGE_TIMEOUT = 0.5
DIAGNOSTICS_PERIOD = 1.0  # between two messages on /diagnostics
DISCOVERY_PERIOD = 0.02  # between two checks whether the server of a call is available
GOAL_TIMEOUT = 1.0  # for a goal to end once its method has returned
LATE_PERIOD = 5.0  # for which a late cycle makes the status a warning
RECONFIGURE_TIMEOUT = 2.0  # for reconfigure to return, as the executor waits for it
RESULT_TIMEOUT = 0.2  # for a client to ask for the result of its goal
RETURN_TIMEOUT = 0.2  # for deactivate and cleanup to return once their waits have ended
SERVER_CHECK_PERIOD = 0.5  # between two checks whether the servers of all clients are available
SERVER_LOST_TIMEOUT = 2.0  # for an action server to come back before its goals are lost
SIGNAL_CHECK_PERIOD = 0.5  # between two chances for Python to call signal handlers
STOP_TIMEOUT = 2.0  # default of the parameter stop_timeout
WARNING_PERIOD = 10.0  # between two warnings about the same thing
