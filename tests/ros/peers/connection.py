"""Wait for connections, of which ROS 1 tells a client only half: that it hears the server."""

from xmlrpc.client import ServerProxy

import rosgraph
import rosnode
import rospy


def sends_to(client):
    """Return whether the server sends to a client, which is later than that is connected."""
    server = client.last_status_msg._connection_header["callerid"]
    _, _, links = ServerProxy(rosnode.get_api_uri(rosgraph.Master("/peer"), server)).getBusInfo("")
    topics = {topic for _, node, _, _, topic, *_ in links if node == rospy.get_name()}
    return {client.feedback_sub.resolved_name, client.result_sub.resolved_name} <= topics
