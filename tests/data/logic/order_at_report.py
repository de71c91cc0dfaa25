"""Order what the next call does as soon as one is reported, as a test can; print what they did."""

import recorder


def order_next(name, *_):
    if name == "activate":
        recorder.ORDERS[name].append(["refuse"])


recorder.report = order_next
logic = recorder._Recorder(None)
print(logic.activate(), logic.activate())
