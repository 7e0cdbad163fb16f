# SPDX-License-Identifier: Apache-2.0
"""Exact gradients of NumPy expressions by reverse accumulation.

A Tensor holds a value and, for each tensor that it was computed from, the function that hands a
gradient back to it. Values may be complex: at x + i·t·v with a tiny t, the imaginary part of a
gradient over t is the Hessian times v, to rounding. So no operation here conjugates, and branches
look at real parts alone.
"""

import itertools

import numpy as np

_numbers = itertools.count()


class Tensor:
    """An array and how it was made. parents: [(tensor, gradient of the result -> its gradient)]."""

    __array_ufunc__ = None  # so that array + tensor asks the tensor

    def __init__(self, value, parents=()):
        self.value = np.asarray(value)
        self.parents = parents
        self.number = next(_numbers)

    shape = property(lambda self: self.value.shape)

    def __add__(self, other):
        other = tensor(other)
        return Tensor(
            self.value + other.value,
            [(self, lambda g: _fold(g, self.shape)), (other, lambda g: _fold(g, other.shape))],
        )

    def __mul__(self, other):
        other = tensor(other)
        return Tensor(
            self.value * other.value,
            [
                (self, lambda g: _fold(g * other.value, self.shape)),
                (other, lambda g: _fold(g * self.value, other.shape)),
            ],
        )

    def __matmul__(self, other):
        other = tensor(other)
        return Tensor(
            self.value @ other.value,
            [
                (self, lambda g: _fold(g @ np.swapaxes(other.value, -1, -2), self.shape)),
                (other, lambda g: _fold(np.swapaxes(self.value, -1, -2) @ g, other.shape)),
            ],
        )

    def __getitem__(self, index):
        def scatter(g):
            out = np.zeros(self.shape, g.dtype)
            if _is_plain(index):
                out[index] = g
            else:
                np.add.at(out, index, g)  # an entry may be picked twice
            return out

        return Tensor(self.value[index], [(self, scatter)])

    def sum(self, axis=None):
        def spread(g):
            return np.broadcast_to(g if axis is None else np.expand_dims(g, axis), self.shape)

        return Tensor(self.value.sum(axis=axis), [(self, spread)])

    def transpose(self):
        """The last two axes swapped."""
        return Tensor(np.swapaxes(self.value, -1, -2), [(self, lambda g: np.swapaxes(g, -1, -2))])

    def __neg__(self):
        return self * -1.0

    def __sub__(self, other):
        return self + -tensor(other)

    def __rsub__(self, other):
        return -self + other

    def __truediv__(self, other):
        return self * reciprocal(other) if isinstance(other, Tensor) else self * (1.0 / other)

    def __rtruediv__(self, other):
        return reciprocal(self) * other

    def __rmatmul__(self, other):
        return tensor(other) @ self

    __radd__, __rmul__ = __add__, __mul__


def _is_plain(index):
    """Whether an index picks no entry twice: it holds no list of places."""
    parts = index if isinstance(index, tuple) else (index,)
    return not any(isinstance(part, (list, np.ndarray)) for part in parts)


def tensor(value):
    return value if isinstance(value, Tensor) else Tensor(value)


def _fold(g, shape):
    """The gradient of an array that was broadcast from `shape`: summed where it was repeated."""
    g = g.sum(axis=tuple(range(g.ndim - len(shape))))
    repeated = tuple(k for k, n in enumerate(shape) if n == 1 and g.shape[k] != 1)
    return g.sum(axis=repeated, keepdims=True) if repeated else g


def _elementwise(x, value, slope):
    return Tensor(value, [(x, lambda g: g * slope)])


def reciprocal(x):
    return _elementwise(x, 1.0 / x.value, -1.0 / x.value**2)


def sin(x):
    return _elementwise(x, np.sin(x.value), np.cos(x.value))


def cos(x):
    return _elementwise(x, np.cos(x.value), -np.sin(x.value))


def log(x):
    return _elementwise(x, np.log(x.value), 1.0 / x.value)


def sqrt(x):
    root = np.sqrt(x.value)
    return _elementwise(x, root, 0.5 / root)


def where(condition, yes, no):
    """Picks element by element. Whoever calls keeps both sides finite."""
    yes, no = tensor(yes), tensor(no)
    return Tensor(
        np.where(condition, yes.value, no.value),
        [
            (yes, lambda g: _fold(np.where(condition, g, 0.0), yes.shape)),
            (no, lambda g: _fold(np.where(condition, 0.0, g), no.shape)),
        ],
    )


def concatenate(parts, axis=0):
    parts = [tensor(p) for p in parts]
    ends = np.cumsum([p.shape[axis] for p in parts])

    def share(end, size):
        return lambda g: np.take(g, np.arange(end - size, end), axis=axis)

    return Tensor(
        np.concatenate([p.value for p in parts], axis=axis),
        [(p, share(end, p.shape[axis])) for p, end in zip(parts, ends)],
    )


def stack(parts, axis=0):
    """Joins along a new axis, counted from the front."""
    new = (slice(None),) * axis + (None,)
    return concatenate([tensor(p)[new] for p in parts], axis)


def gradients(result, inputs):
    """The gradient of a scalar tensor with respect to each of `inputs`."""
    reached, waiting = {}, [result]
    while waiting:
        node = waiting.pop()
        if node.number not in reached:
            reached[node.number] = node
            waiting += [parent for parent, _ in node.parents]
    found = {result.number: np.ones((), result.value.dtype)}
    for number in sorted(reached, reverse=True):  # a result is younger than what it is made of
        if number not in found:
            continue
        for parent, hand_back in reached[number].parents:
            g = hand_back(found[number])
            found[parent.number] = found[parent.number] + g if parent.number in found else g
    return [found.get(x.number, np.zeros(x.shape)) for x in inputs]
