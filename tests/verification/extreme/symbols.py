"""What a mode has to do: symbols of the Gaussian kernels in closed form (docs/theory/periodic.md, section 1), and how far
lines between walls are off."""
import math


def upper(n, s):
    """Q(n, s): exp(-s) times the first n terms of its series."""
    term, total = math.exp(-s), 0.0
    for m in range(n):
        total += term
        term *= s / (m + 1)
    return total


def lower(n, s):
    """P(n, s) = 1 - Q(n, s), with its digits where s is small."""
    if s > n:
        return 1 - upper(n, s)
    term = math.exp(-s) * s**n / math.factorial(n)
    total, m = 0.0, n
    while term > 1e-18 * total:
        total += term
        m += 1
        term *= s / m
    return total


def morris(k, h, order):
    """Morris' Laplacian at the wave vector k; h along each axis."""
    n = order // 2
    s = sum((a * b) ** 2 for a, b in zip(k, h)) / 4
    if s == 0:
        return 0.0
    return -sum(a * a for a in k) * (s * upper(n - 1, s) + n * lower(n, s)) / s


def second(k, h, order):
    """The second derivative of the kernel."""
    s = sum((a * b) ** 2 for a, b in zip(k, h)) / 4
    return -sum(a * a for a in k) * upper(order // 2, s)


def wallDefect(decayed, n):
    """How far a mode between walls on n intervals may be off after it decayed by exp(-decayed): the second derivative at
    walls is off by (pi/n)^3.5, until that has spread over a spacing; the first eigenvalue of continued lines by 1e-6."""
    h = math.pi / n
    return min(decayed, h**2) * h**3.5 + 1e-6 * min(1, decayed)
