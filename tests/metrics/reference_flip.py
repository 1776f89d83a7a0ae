#!/usr/bin/env python3
"""LDR-FLIP from the definition of Andersson et al. 2020, with whole two-dimensional kernels in
double precision: where the numbers of flip_test.cpp come from. Needs numpy; run it to print them."""
import math

import numpy as np

PPD = 67.0206
RGB_TO_XYZ = np.array([[0.4123907993, 0.3575843394, 0.1804807884],
                       [0.2126390059, 0.7151686788, 0.0721923154],
                       [0.0193308187, 0.1191947798, 0.9505321522]])
WHITE = RGB_TO_XYZ @ np.ones(3)


def opponent(rgb):
    xyz = rgb @ RGB_TO_XYZ.T / WHITE
    return np.stack([116 * xyz[..., 1] - 16, 500 * (xyz[..., 0] - xyz[..., 1]),
                     200 * (xyz[..., 1] - xyz[..., 2])], -1)


def from_opponent(o):
    y = (o[..., 0] + 16) / 116
    xyz = np.stack([o[..., 1] / 500 + y, y, y - o[..., 2] / 200], -1) * WHITE
    return xyz @ np.linalg.inv(RGB_TO_XYZ).T


def hunt_lab(rgb):
    t = rgb @ RGB_TO_XYZ.T / WHITE
    d = 6 / 29
    f = np.where(t > d ** 3, np.cbrt(t), t / (3 * d * d) + 4 / 29)
    lightness = 116 * f[..., 1] - 16
    return np.stack([lightness, 0.01 * lightness * 500 * (f[..., 0] - f[..., 1]),
                     0.01 * lightness * 200 * (f[..., 1] - f[..., 2])], -1)


def hyab(a, b):
    d = a - b
    return np.abs(d[..., 0]) + np.hypot(d[..., 1], d[..., 2])


def convolve(image, kernel):
    r = kernel.shape[0] // 2
    padded = np.pad(image, r, mode="edge")
    out = np.zeros_like(image)
    for j in range(kernel.shape[0]):
        for i in range(kernel.shape[1]):
            out += kernel[j, i] * padded[j:j + image.shape[0], i:i + image.shape[1]]
    return out


def grid(radius):
    return np.meshgrid(np.arange(-radius, radius + 1.0), np.arange(-radius, radius + 1.0))


def sensitivity(terms):
    radius = math.ceil(3 * math.sqrt(0.04 / (2 * math.pi ** 2)) * PPD)
    x, y = grid(radius)
    z = (x * x + y * y) / PPD ** 2
    g = sum(a * math.sqrt(math.pi / b) * np.exp(-math.pi ** 2 * z / b) for a, b in terms)
    return g / g.sum()


def features(y_channel):
    sigma = 0.5 * 0.082 * PPD
    x, y = grid(math.ceil(3 * sigma))
    g = np.exp(-(x * x + y * y) / (2 * sigma * sigma))
    result = []
    for kernel in (-x * g, (x * x / sigma ** 2 - 1) * g):
        kernel = np.where(kernel < 0, kernel / -kernel[kernel < 0].sum(),
                          kernel / kernel[kernel > 0].sum())
        result.append(np.hypot(convolve(y_channel, kernel), convolve(y_channel, kernel.T)))
    return result


def flip(measured, truth):
    kernels = [sensitivity([(1, 0.0047)]), sensitivity([(1, 0.0053)]),
               sensitivity([(34.1, 0.04), (13.5, 0.025)])]
    labs, found = [], []
    for rgb in (measured, truth):
        o = opponent(np.clip(rgb, 0, 1))
        found.append(features((o[..., 0] + 16) / 116))
        o = np.stack([convolve(o[..., c], kernels[c]) for c in range(3)], -1)
        labs.append(hunt_lab(np.clip(from_opponent(o), 0, 1)))
    most = hyab(hunt_lab(np.array([0.0, 1, 0])), hunt_lab(np.array([0.0, 0, 1]))) ** 0.7
    power = hyab(*labs) ** 0.7
    knee = 0.4 * most
    color = np.where(power < knee, 0.95 / knee * power,
                     0.95 + (power - knee) / (most - knee) * 0.05)
    feature = np.maximum(np.abs(found[0][0] - found[1][0]), np.abs(found[0][1] - found[1][1]))
    return color ** (1 - np.sqrt(feature / math.sqrt(2)))


def pictures(width=24, height=16):
    """The same as in flip_test.cpp: a gradient with a bar, and the bar elsewhere in another colour."""
    x, y = np.meshgrid(np.arange(width, dtype=float), np.arange(height, dtype=float))
    base = np.stack([x / width, y / height, 0.25 + 0 * x], -1)
    a, b = base.copy(), base.copy()
    a[:, 8:11] = [0.9, 0.1, 0.2]
    b[:, 12:15] = [0.1, 0.6, 0.9]
    return a, b


if __name__ == "__main__":
    a, b = pictures()
    f = flip(a, b)
    print("bars: mean %.6f, (4,3) %.6f, (9,8) %.6f, (13,15) %.6f" %
          (f.mean(), f[3, 4], f[8, 9], f[15, 13]))
    flat = np.full((16, 24, 3), 0.5)
    for name, other in (("lighter", flat + 0.1), ("red", flat * [1.2, 1, 1]),
                        ("black", flat * 0)):
        print("%s: %.6f" % (name, flip(flat, other).mean()))
    white, black = np.ones((16, 24, 3)), np.zeros((16, 24, 3))
    print("white on black: %.6f" % flip(white, black).mean())
    blue, green = black + [0, 0, 1], black + [0, 1, 0]
    print("blue on green: %.6f" % flip(blue, green).mean())
