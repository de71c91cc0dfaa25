"""What the templates need to write Python. Each public function is a filter."""


def dependencies_from_template(ros_distro):
    """Return the packages every package of this model needs."""
    return ["rclpy"]


def dependencies_from_interface(kind, attributes, ros_distro):
    """Return the packages that one interface needs: that of its type."""
    return [attributes["type"].split("/")[0]] if "type" in attributes else []


def python_type(type_):
    """Return the Python name of a type: `std_msgs/msg/String` gives `std_msgs.msg.String`."""
    return type_.replace("/", ".")


def modules(topics):
    """Return the modules of the types of some topics, each once and sorted."""
    return sorted({python_type(topic["type"]).rpartition(".")[0] for topic in topics})
