"""Talk to the written logic of examples/logic: contact_analysis.py PEER learn|remember FOLDER."""

import contextlib
import importlib
import random
import sys
import threading
import time

NODE = "contact_evaluate"
CONTACTS = {"toe": (0.1, 0.02, 0.0), "heel": (-0.1, 0.0, 0.0)}
UNTIL_CANCELED = 0.0
ENOUGH = 10  # feedback for a majority: 3 % of the centers lie outside their contact
_, peer_name, part, folder = sys.argv
peer = importlib.import_module(peer_name).Peer()
peer.wait_until_active(NODE)
cop = peer.publisher("cop", "geometry_msgs/msg/Point")
plots = peer.hear("plot_learn_cop", "contact_msgs/msg/PointArray")


@contextlib.contextmanager
def measuring(center):
    """Play the sensor: publish centers of pressure that scatter about one by 2 mm."""
    stop = threading.Event()

    def publish():
        while not stop.wait(0.002):
            x, y, z = (random.gauss(value, 0.002) for value in center)
            cop.publish(peer.message("geometry_msgs/msg/Point", x=x, y=y, z=z))

    sensor = threading.Thread(target=publish)
    sensor.start()
    try:
        yield
    finally:
        stop.set()
        sensor.join()


def wait_for(condition, what):
    end = time.monotonic() + 10
    while not condition():
        assert time.monotonic() < end, what
        time.sleep(0.01)


def goal(action, **fields):
    return peer.goal(action, f"contact_msgs/action/{action.capitalize()}Contact", **fields)


def learn(contact, center):
    with measuring(center):
        learning = goal("learn", contact=contact)
        outcome, result = learning.answer()
    assert (outcome, result.samples) == ("succeeded", 200), (outcome, result)
    progress = [message.progress for message in learning.feedback]
    assert [0.0, *progress, 1.0] == sorted([0.0, *progress, 1.0]), progress


def evaluated(center):
    """Return the contact that the node finds."""
    for duration in (0.5, 2.0, 8.0):
        with measuring(center):
            evaluation = goal("evaluate", duration=duration)
            outcome, result = evaluation.answer()
        assert outcome == "succeeded", outcome
        if len(evaluation.feedback) >= ENOUGH:
            break  # on a busy machine half a second may not bring it
    last = evaluation.feedback[-1].cop
    assert abs(last.x - center[0]) < 0.02, last
    return result.contact


def check_evaluation():
    for name, center in CONTACTS.items():
        assert evaluated(center) == name
    assert evaluated((0.0, 0.3, 0.0)) == "", "a contact that was never learned"


def ask(service, where):
    return peer.call(service, "contact_msgs/srv/SetString", data=where)


def learn_and_store():
    assert peer.get_parameter(NODE, "samples") == 200
    assert goal("learn", contact="").answer()[0] == "aborted"
    learn("toe", CONTACTS["toe"])
    wait_for(lambda: plots, "the contact is not plotted")
    plotted = [point.x for point in plots[0].points]
    assert len(plotted) == 200
    assert abs(sum(plotted) / 200 - CONTACTS["toe"][0]) < 0.001, plotted
    assert peer.set_parameter(NODE, "pub_sample", False)
    learn("heel", CONTACTS["heel"])
    check_evaluation()
    assert len(plots) == 1, "plotted, though pub_sample is false"
    assert ask("store", folder).success
    for service in ("store", "load"):
        answer = ask(service, f"{folder}/nowhere")
        assert not answer.success, service
        assert "contacts.txt cannot be" in answer.message, answer
    check_evaluation()


def remember():
    """Load in a new node what another has learned; the node ends while it evaluates."""
    assert evaluated(CONTACTS["toe"]) == "", "known before it is loaded"
    answer = ask("load", folder)
    assert answer.success, answer.message
    check_evaluation()
    if hasattr(peer, "change_state"):
        evaluation = goal("evaluate", duration=UNTIL_CANCELED)
        assert peer.change_state(NODE, "deactivate")
        assert evaluation.answer()[0] == "aborted"
        assert peer.change_state(NODE, "activate")
        assert evaluated(CONTACTS["heel"]) == "heel"
    evaluation = goal("evaluate", duration=UNTIL_CANCELED)
    with measuring(CONTACTS["heel"]):
        wait_for(lambda: len(evaluation.feedback) >= ENOUGH, "no feedback")
    evaluation.cancel()
    outcome, result = evaluation.answer()
    assert (outcome, result.contact) == ("canceled", "heel"), (outcome, result)
    evaluation = goal("evaluate", duration=UNTIL_CANCELED)
    with measuring(CONTACTS["heel"]):
        wait_for(lambda: evaluation.feedback, "no feedback")


{"learn": learn_and_store, "remember": remember}[part]()
peer.close()
