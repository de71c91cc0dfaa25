# Copyright 2026 Ada Lovelace
# SPDX-License-Identifier: Apache-2.0

"""Time-outs and periods of the node, in seconds."""

CONNECT_TIMEOUT = 1.0  # for a service server to accept a connection
DIAGNOSTICS_PERIOD = 1.0  # between two messages on /diagnostics
DISCOVERY_PERIOD = 0.1  # between two checks whether the server of a call is available
LATE_PERIOD = 5.0  # for which a late cycle makes the status a warning
MISSING_CHECK_PERIOD = 2.0  # between two checks for missing servers, each of which asks the master
RECONFIGURE_TIMEOUT = 2.0  # for reconfigure to return
RETURN_TIMEOUT = 0.2  # for deactivate and cleanup to return once their waits have ended
SERVER_CHECK_PERIOD = 0.5  # between two checks whether the servers of goals are available
SERVER_LOST_TIMEOUT = 1.0  # for an action server to come back before its goals are lost
SHUTDOWN_DELAY = 0.2  # for the last messages and results to be sent before ROS shuts down
SIGNAL_CHECK_PERIOD = 0.5  # between two chances for Python to call signal handlers
STATUS_PERIOD = 0.2  # between two status messages of an action server
STATUS_TIMEOUT = 5.0  # for an ended goal to remain in the status of its server
STOP_MARGIN = 3.0  # for ROS itself when the node stops, in addition to stop_timeout
STOP_TIMEOUT = 2.0  # default of the parameter stop_timeout
UNREGISTER_TIMEOUT = 5.0  # for the master to unregister the node
WARNING_PERIOD = 10.0  # between two warnings about the same thing
