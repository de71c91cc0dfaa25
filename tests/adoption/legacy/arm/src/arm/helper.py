class Filter:
    gain = 1.0

    def step(self, value):
        return self.gain * value
