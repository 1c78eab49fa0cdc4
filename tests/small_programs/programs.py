"""The programs and what they give."""

import math

import numpy as np
from scipy import linalg as sl, optimize
from values import *

rng = np.random.default_rng(7)


def r(*s):
    return np.round(rng.uniform(-2, 2, s), 3)


def spd(n):
    A = r(n, n)
    return np.round(A @ A.T + n * np.eye(n), 3)


a, b, c = 1.5, -0.75, 2.25
A3, B3, C3 = r(3, 3), r(3, 3), r(3, 3)
A2, B2 = r(2, 2), r(2, 2)
u3, v3, w3 = r(3), r(3), r(3)
n5, m5 = r(5), r(5)
M45 = r(4, 5)
N45 = r(4, 5)
S5 = spd(5)
S4 = spd(4)
S3 = spd(3)

case("add_scalars", "c = a + b\nwhere\na ∈ ℝ\nb ∈ ℝ", [real(a), real(b)], c=a + b)
case(
    "add_matrices",
    "A = B + C\nwhere\nB: matrix(3,2)\nC: matrix(3,2)",
    [fixed_matrix(M45[:3, :2]), fixed_matrix(N45[:3, :2])],
    A=M45[:3, :2] + N45[:3, :2],
)
case(
    "side_by_side",
    "B = [ A C ]\nwhere\nA: ℝ^(3×3) : a\nC: ℝ^(3×3) : a",
    [fixed_matrix(A3), fixed_matrix(B3)],
    B=np.hstack([A3, B3]),
)
case(
    "on_top",
    "B = [ A ; C ]\nwhere\nA: ℝ^(2×2): a matrix\nC: ℝ^(2×2)",
    [fixed_matrix(A2), fixed_matrix(B2)],
    B=np.vstack([A2, B2]),
)
Z2 = np.zeros((2, 2))
case(
    "block_zero",
    "B = [ A  0\n      0  C ]\nwhere\nA: ℝ^(2 × 2)\nC: ℝ^(2 × 2)",
    [fixed_matrix(A2), fixed_matrix(B2)],
    B=np.block([[A2, Z2], [Z2, B2]]),
)
case(
    "block_affine",
    "B = [ A a\n      0 1 ]\nwhere\nA ∈ ℝ^(3×3)\na ∈ ℝ^3",
    [fixed_matrix(A3), fixed_vector(u3)],
    B=np.block([[A3, u3[:, None]], [np.zeros((1, 3)), np.ones((1, 1))]]),
)
case(
    "block_ones",
    "C = [ 1_n,m A; I 0 ]\nwhere\nA ∈ ℝ^(n×m)",
    [matrix(M45)],
    C=np.block([[np.ones((4, 5)), M45], [np.eye(5), np.zeros((5, 5))]]),
)
case(
    "block_row_one",
    "y = [A I_3\n     0 1]\nwhere\nA ∈ ℝ^(3×2)",
    [fixed_matrix(M45[:3, :2])],
    y=np.block([[M45[:3, :2], np.eye(3)], [np.zeros((1, 2)), np.ones((1, 3))]]),
)
case(
    "block_column",
    "C = [A u\n     uᵀ 1]\nwhere\nA ∈ ℝ^(3×3)\nu ∈ ℝ^3",
    [fixed_matrix(A3), fixed_vector(u3)],
    C=np.block([[A3, u3[:, None]], [u3[None, :], np.ones((1, 1))]]),
)
case(
    "row",
    "A = [a b c]\nwhere\na ∈ ℝ\nb ∈ ℝ\nc ∈ ℝ",
    [real(a), real(b), real(c)],
    A=np.array([[a, b, c]]),
)
sw = [real(x) for x in n5]
case(
    "sum_of_sequence",
    "b = ∑_i w_i\nwhere\nw_i ∈ ℝ: weights",
    [sequence(sw)],
    b=n5.sum(),
)
case(
    "sum_filtered",
    "b = sum_(i for i > 1) w_i\nwhere\nw ∈ ℝ^n",
    [vector(n5)],
    b=n5[1:].sum(),
)
case(
    "sum_filtered_twice",
    "b = ∑_(i for i > 1 and i ≤ 3) w_i\nwhere\nw ∈ ℝ^5",
    [fixed_vector(n5)],
    b=n5[1:3].sum(),
)
case("sum_nested", "b = ∑_i ∑_j A_i,j\nwhere\nA ∈ ℝ^(m×n)", [matrix(M45)], b=M45.sum())
case(
    "sum_off_diagonal",
    "b = ∑_i ∑_(j for j ≠ i) A_ij\nwhere\nA ∈ ℝ^(n×n)",
    [matrix(S5)],
    b=S5.sum() - np.trace(S5),
)
xs = [r(3) for _ in range(4)]
ws = r(4)
SX = sequence([fixed_vector(x) for x in xs])
SW = sequence([real(w) for w in ws])
case(
    "sum_outer",
    "A = ∑_i w_i x_i x_iᵀ\nwhere\nw_i ∈ ℝ\nx_i ∈ ℝ^3",
    [SW, SX],
    A=sum(w * np.outer(x, x) for w, x in zip(ws, xs)),
)
mean = sum(xs) / 4
case(
    "covariance",
    "`x̄` = 1/n ∑_i x_i\nC = 1/n ∑_i (x_i - `x̄`)(x_i - `x̄`)ᵀ\nwhere\nx_i ∈ ℝ^3\nn ∈ ℤ",
    [SX, integer(4)],
    C=sum(np.outer(x - mean, x - mean) for x in xs) / 4,
)
case(
    "entries",
    "a_i = b_i c_i\nwhere\nb ∈ ℝ^n\nc ∈ ℝ^n",
    [vector(n5), vector(m5)],
    a=n5 * m5,
)
case(
    "entries_of_matrix",
    "C_ij = A_ij B_ij + 1\nwhere\nA ∈ ℝ^(m×n)\nB ∈ ℝ^(m×n)",
    [matrix(M45), matrix(N45)],
    C=M45 * N45 + 1,
)
case("transposed_entries", "C_ij = A_ji\nwhere\nA ∈ ℝ^(m×n)", [matrix(M45)], C=M45.T)
case(
    "matrix_product_by_entries",
    "C_ij = ∑_k A_ik B_kj\nwhere\nA ∈ ℝ^(m×n)\nB ∈ ℝ^(n×m)",
    [matrix(M45), matrix(N45.T)],
    C=M45 @ N45.T,
)
case(
    "hadamard",
    "C = A∘B\nwhere\nA ∈ ℝ^(m×n)\nB ∈ ℝ^(m×n)",
    [matrix(M45), matrix(N45)],
    C=M45 * N45,
)
case(
    "kronecker",
    "C = A⊗B\nwhere\nA ∈ ℝ^(m×n)\nB ∈ ℝ^(p×q)",
    [matrix(M45), matrix(A2)],
    C=np.kron(M45, A2),
)
case(
    "kronecker_vectors",
    "C = u⊗v\nwhere\nu ∈ ℝ^3\nv ∈ ℝ^n",
    [fixed_vector(u3), vector(n5)],
    C=np.kron(u3[:, None], n5[:, None]),
)
case(
    "frobenius",
    "c = A:B\nwhere\nA ∈ ℝ^(m×n)\nB ∈ ℝ^(m×n)",
    [matrix(M45), matrix(N45)],
    c=(M45 * N45).sum(),
)
case(
    "cross",
    "c = a × b\nwhere\na ∈ ℝ^3\nb ∈ ℝ^3",
    [fixed_vector(u3), fixed_vector(v3)],
    c=np.cross(u3, v3),
)
case(
    "dot",
    "c = a⋅b + a·b + aᵀb\nwhere\na ∈ ℝ^n\nb ∈ ℝ^n",
    [vector(n5), vector(m5)],
    c=3 * (n5 @ m5),
)
case(
    "inner",
    "c = <a,b> + ⟨a,b⟩_M\nwhere\na ∈ ℝ^n\nb ∈ ℝ^n\nM ∈ ℝ^(n×n)",
    [vector(n5), vector(m5), matrix(S5)],
    c=n5 @ m5 + m5 @ S5 @ n5,
)
case(
    "solve",
    "c = A \\ b\nd = A⁻¹ b\nf = A^(-1) b\ng = A^-1 b\nwhere\nA ∈ ℝ^(n×n)\nb ∈ ℝ^n",
    [matrix(S5 + 1.5 * np.eye(5)), vector(n5)],
    c=np.linalg.solve(S5 + 1.5 * np.eye(5), n5),
    d=np.linalg.solve(S5 + 1.5 * np.eye(5), n5),
    f=np.linalg.solve(S5 + 1.5 * np.eye(5), n5),
    g=np.linalg.solve(S5 + 1.5 * np.eye(5), n5),
)
case(
    "solve_matrix",
    "C = A⁻¹ B\nD = A⁻¹ A⁻¹ B\nwhere\nA ∈ ℝ^(3×3)\nB ∈ ℝ^(3×2)",
    [fixed_matrix(S3), fixed_matrix(M45[:3, :2])],
    C=np.linalg.solve(S3, M45[:3, :2]),
    D=np.linalg.solve(S3, np.linalg.solve(S3, M45[:3, :2])),
)
case(
    "inverse",
    "B = (A + 2I_3)^(-1) + C\nwhere\nA ∈ ℝ^(3×3)\nC ∈ ℝ^(3×3)",
    [fixed_matrix(S3), fixed_matrix(C3)],
    B=np.linalg.inv(S3 + 2 * np.eye(3)) + C3,
)
case(
    "matrix_power",
    "B = A^2 A^3\nC = A²\nwhere\nA ∈ ℝ^(n×n)",
    [matrix(A3)],
    B=np.linalg.matrix_power(A3, 5),
    C=A3 @ A3,
)
case(
    "matrix_root",
    "B = A^(-1/2)\nC = A^(1/2)\nwhere\nA ∈ ℝ^(n×n)",
    [matrix(S4)],
    B=np.linalg.inv(sl.sqrtm(S4).real),
    C=sl.sqrtm(S4).real,
)
case(
    "scalar_power",
    "c = a^(b+1) + a^b\nd = a^-b\nwhere\na ∈ ℝ\nb ∈ ℝ",
    [real(a), real(b)],
    c=a ** (b + 1) + a**b,
    d=a**-b,
)
case(
    "determinant",
    "d = |A|\ne = |B|\nwhere\nA ∈ ℝ^(3×3)\nB ∈ ℝ^(n×n)",
    [fixed_matrix(A3), matrix(S5)],
    d=np.linalg.det(A3),
    e=np.linalg.det(S5),
)
nn = np.linalg.norm
case(
    "vector_norms",
    "c = ‖a‖ + ‖a‖_2\nd = ‖a‖_1\nf = ‖a‖_∞\ng = ||a||_3\nh = ‖a‖²\nk = ||a||_2^2 + ||a||^2_2 + ||a||₂²\nz = ||a||_0\nwhere\na ∈ ℝ^n",
    [vector(n5)],
    c=2 * nn(n5),
    d=nn(n5, 1),
    f=nn(n5, np.inf),
    g=nn(n5, 3),
    h=n5 @ n5,
    k=3 * (n5 @ n5),
    z=5,
)
case(
    "matrix_norms",
    "c = ‖A‖\nd = ‖A‖_F\nf = ‖A‖_*\nwhere\nA ∈ ℝ^(n×m)",
    [matrix(M45)],
    c=nn(M45),
    d=nn(M45),
    f=nn(M45, "nuc"),
)
case(
    "weighted_norm",
    "c = ‖a‖_P\nd = ‖a‖_P^2\nf = ‖a‖_p\nwhere\na ∈ ℝ^n\nP ∈ ℝ^(n×n)\np ∈ ℝ",
    [vector(n5), matrix(S5), real(2.5)],
    c=math.sqrt(n5 @ S5 @ n5),
    d=n5 @ S5 @ n5,
    f=(np.abs(n5) ** 2.5).sum() ** (1 / 2.5),
)
case("absolute", "c = |a| + |b|\nwhere\na,b ∈ ℝ", [real(a), real(b)], c=abs(a) + abs(b))
case(
    "callback",
    "b = f(a)\nwhere\nf ∈ ℝ → ℝ\na ∈ ℝ",
    [rust("|x: f64| x * x + 1.0"), real(a)],
    b=a * a + 1,
)
case(
    "callback_vectors",
    "b = f(a, c)\nwhere\nf ∈ ℝ,ℝ^n → ℝ^n\na ∈ ℝ\nc ∈ ℝ^n",
    [rust("|x: f64, v: DVector<f64>| v * x"), real(a), vector(n5)],
    b=a * n5,
)
case(
    "callback_matrix",
    "b = f(P)\nwhere\nf ∈ ℝ^(n×m) → ℝ^(m×n)\nP ∈ ℝ^(n×m)",
    [rust("|p: DMatrix<f64>| p.transpose()"), matrix(M45)],
    b=M45.T,
)
case(
    "callback_nothing",
    "y = f() + g()\nwhere\nf ∈ {} → ℝ\ng ∈ ∅ -> ℝ",
    [rust("|| 2.5"), rust("|| 3.5")],
    y=6.0,
)
case(
    "callback_each",
    "y_i = f(x_i)\nwhere\nf ∈ ℝ^3 → ℝ\nx_i ∈ ℝ^3",
    [rust("|v: DVec3| v.x + 2.0 * v.z"), SX],
    y=[x[0] + 2 * x[2] for x in xs],
)
case(
    "callbacks",
    "b = ∑_i f_i(q) w_i\nwhere\nf_i ∈ ℝ^3 → ℝ\nq ∈ ℝ^3\nw_i ∈ ℝ",
    [
        rust("[(|v: DVec3| v.x) as fn(DVec3) -> f64, |v: DVec3| v.y, |v: DVec3| v.z]"),
        fixed_vector(u3),
        sequence([real(1), real(2), real(3)]),
    ],
    b=u3 @ [1, 2, 3],
)
case(
    "callback_two_results",
    "b, c = f(a)\nwhere\nf ∈ ℝ → ℝ, ℝ\na ∈ ℝ",
    [rust("|x: f64| (x, x * x)"), real(a)],
    b=a,
    c=a * a,
)
case("cases", "y = { 1 if x > 0\n      0 otherwise\nwhere\nx ∈ ℝ", [real(a)], y=1)
case(
    "cases_and",
    "y = { a if x > 0 and a < 2\n      b if x == 0 or b != 3\n      0 otherwise\nwhere\nx, a, b ∈ ℝ",
    [real(-1), real(a), real(b)],
    y=b,
)
case(
    "cases_set",
    "y = { a if k ∈ S\n      2a if k ∉ S\n      0 otherwise\nwhere\na ∈ ℝ\nk ∈ ℤ\nS ∈ {ℤ}",
    [real(a), integer(4), integer_set([1, 2, 3])],
    y=2 * a,
)
case(
    "cases_entries",
    "y_i = { x_i if x_i > 0\n      0 otherwise\nwhere\nx ∈ ℝ^n",
    [vector(n5)],
    y=np.maximum(n5, 0),
)
case(
    "cases_matrix",
    "A_ij = { 1 if i = j\n         B_ij otherwise\nwhere\nB ∈ ℝ^(n×n)",
    [matrix(S4)],
    A=S4 - np.diag(np.diag(S4)) + np.eye(4),
)
case(
    "local_function",
    "f(x) = x^2 + 1 where x ∈ ℝ\ny = f(a) + f(2)\na ∈ ℝ",
    [real(a)],
    y=a * a + 1 + 5,
)
case(
    "local_function_two",
    "f(x,y) = x y where x, y ∈ ℝ\nz = f(a, 3)\na ∈ ℝ",
    [real(a)],
    z=3 * a,
)
case(
    "local_function_affine",
    "f(x) = Ax + b where x ∈ ℝ^n\ny = f(c)\nA ∈ ℝ^(n×n)\nb ∈ ℝ^n\nc ∈ ℝ^n",
    [matrix(S5), vector(n5), vector(m5)],
    y=S5 @ m5 + n5,
)
case(
    "local_function_any_size",
    "g(u, v) = uᵀv where u ∈ ℝ^k, v ∈ ℝ^k\ny = g(a,b)\nz = g(c,c)\na,b ∈ ℝ^n\nc ∈ ℝ^3",
    [vector(n5), vector(m5), fixed_vector(u3)],
    y=n5 @ m5,
    z=u3 @ u3,
)
th, ph, Rr = 0.7, 0.4, 2.0
case(
    "sphere",
    """sin, cos from trigonometry
`x(θ, ϕ)` = [Rcos(θ)cos(ϕ)
             Rsin(θ)cos(ϕ)
             Rsin(ϕ)]
where
ϕ ∈ ℝ : angle between 0 and 2π
θ ∈ ℝ : angle between -π/2 and π/2
R ∈ ℝ : the radius of the sphere""",
    [real(ph), real(th), real(Rr)],
    **{
        "x_θ_ϕ": [
            Rr * math.cos(th) * math.cos(ph),
            Rr * math.sin(th) * math.cos(ph),
            Rr * math.sin(ph),
        ]
    }
)
Pi = [np.eye(3) - np.outer(d, d) / (d @ d) for d in xs]
ps = [r(3) for _ in range(4)]
case(
    "closest_point",
    """given
p_i ∈ ℝ^3: points on lines
d_i ∈ ℝ^3: unit directions along lines
P_i = ( I_3 - d_i d_iᵀ )
q = ( ∑_i P_i )⁻¹ ( ∑_i P_i p_i )""",
    [
        sequence([fixed_vector(p) for p in ps]),
        sequence([fixed_vector(d / nn(d)) for d in xs]),
    ],
    q=np.linalg.solve(sum(Pi), sum(P @ p for P, p in zip(Pi, ps))),
    P=Pi,
)
e1, e2 = r(2), r(2)
case(
    "kernel",
    """Ω = [`e₁` `e₂`][`k₁`   0
                 0    `k₂`] [`e₁`ᵀ
                             `e₂`ᵀ]
where
`k₁` ∈ ℝ  : control
`k₂` ∈ ℝ  : control
`e₁` ∈ ℝ^2: orthogonal direction vectors
`e₂` ∈ ℝ^2: orthogonal direction vectors""",
    [real(a), real(c), fixed_vector(e1), fixed_vector(e2)],
    Omega=np.column_stack([e1, e2]) @ np.diag([a, c]) @ np.vstack([e1, e2]),
)
px = np.abs(r(4))
pp = np.abs(r(5, 4))
case(
    "mutual_information",
    """`I(X;Y)` = ∑_i ∑_j x_j p_i,j log_2(p_i,j/∑_k x_k p_i,k)
where
x ∈ ℝ^n
p ∈ ℝ^(m×n)""",
    [vector(px), matrix(pp)],
    I_X_Y=sum(
        px[j] * pp[i, j] * math.log2(pp[i, j] / (pp[i] @ px))
        for i in range(5)
        for j in range(4)
    ),
)
Rh = np.abs(r(4))
case(
    "demosaic",
    """`C(x,y)` = (∑_n ∑_i c_n,i w_n,i `R̂`_n) / (∑_n ∑_i w_n,i `R̂`_n)
where
c ∈ ℝ^(f×s): the value of the Bayer pixel
w ∈ ℝ^(f×s): the local sample weight
`R̂` ∈ ℝ^f: the local robustness""",
    [matrix(M45), matrix(np.abs(N45)), vector(Rh)],
    C_x_y=(M45 * np.abs(N45) * Rh[:, None]).sum() / (np.abs(N45) * Rh[:, None]).sum(),
)
case(
    "divergence",
    """`D_{KL}` = 1/2 (tr(`Σ₂`⁻¹`Σ₁`) - n + ln(|`Σ₂`|/|`Σ₁`|))
tr from linearalgebra
where
`Σ₁`, `Σ₂` ∈ ℝ^(n×n)""",
    [matrix(S4), matrix(2 * S4 + np.eye(4))],
    D_KL=0.5
    * (
        np.trace(np.linalg.inv(2 * S4 + np.eye(4)) @ S4)
        - 4
        + math.log(np.linalg.det(2 * S4 + np.eye(4)) / np.linalg.det(S4))
    ),
)
P3, U, L, Bm, Cm, Lt, Ut = [r(2, 2) + 2 * np.eye(2) for _ in range(7)]
Ps = [r(2, 2) for _ in range(3)]
inv = np.linalg.inv
Zb = np.zeros((2, 2))
case(
    "block_product",
    """[ P₁  0
  0   P₃ ][ L                 0
            P₃ᵀCP₂ᵀU⁻¹  -`L̃` ][ U  L⁻¹P₁ᵀB
                                0  `Ũ`     ][ P₂  0
                                              0   I_n ]
where
P_i ∈ ℝ^(n×n)
B ∈ ℝ^(n×n)
C ∈ ℝ^(n×n)
L ∈ ℝ^(n×n)
`L̃` ∈ ℝ^(n×n)
U ∈ ℝ^(n×n)
`Ũ` ∈ ℝ^(n×n)""",
    [
        sequence([matrix(p) for p in Ps]),
        matrix(Bm),
        matrix(Cm),
        matrix(L),
        matrix(Lt),
        matrix(U),
        matrix(Ut),
    ],
    ret=np.block([[Ps[0], Zb], [Zb, Ps[2]]])
    @ np.block([[L, Zb], [Ps[2].T @ Cm @ Ps[1].T @ inv(U), -Lt]])
    @ np.block([[U, inv(L) @ Ps[0].T @ Bm], [Zb, Ut]])
    @ np.block([[Ps[1], Zb], [Zb, np.eye(2)]]),
)
al = r(4)
case(
    "vertex_normal",
    """`n(v)` = ( ∑_(i for i ∈ `N₁(v)`) α_i n(T_i) )/‖ ∑_(i for i ∈ `N₁(v)`) α_i n(T_i) ‖
where
T_i ∈ ℝ^3
α_i ∈ ℝ
`N₁(v)` ∈ {ℤ}
n ∈ ℝ^3 → ℝ^3""",
    [
        SX,
        sequence([real(x) for x in al]),
        integer_set([1, 3, 4]),
        rust("|v: DVec3| v * 2.0"),
    ],
    n_v=(lambda s: s / nn(s))(sum(al[i] * 2 * xs[i] for i in (0, 2, 3))),
)
Xm = r(3, 4)
als = r(3)
case(
    "quasi_monte_carlo",
    """∑_i α_i + 1/M ∑_i ∑_j (f(X_i,j)/`p_c`(X_i,j) - (∑_k α_k p_k(X_i,j))/`p_c`(X_i,j))
where
α ∈ ℝ^N
p_j ∈ ℝ → ℝ
X ∈ ℝ^(N×m)
M ∈ ℝ
f ∈ ℝ → ℝ
`p_c` ∈ ℝ → ℝ""",
    [
        vector(als),
        rust("vec![|x: f64| x; 3]"),
        matrix(Xm),
        real(4),
        rust("|x: f64| x * x"),
        rust("|x: f64| x + 5.0"),
    ],
    ret=als.sum()
    + sum((x * x) / (x + 5) - (als.sum() * x) / (x + 5) for x in Xm.flatten()) / 4,
)
vec = [r(3) for _ in range(6)]
case(
    "view_plane",
    """r̄ = v̄×ō
s̄ = ō×ū
n̄ = ū×v̄
`kᵣ` = r̄⋅(`C̄ₐ`-V̄)
`kₙ` = n̄⋅(`C̄ₐ`-V̄)
`x(θ,v)` = (r̄⋅`D_A`(θ, v)+`kᵣ`δ(θ, v))/(n̄⋅`D_A`(θ, v)+`kₙ`δ(θ, v))
where
v̄ ∈ ℝ^3
ō ∈ ℝ^3
ū ∈ ℝ^3
V̄ ∈ ℝ^3
`C̄ₐ` ∈ ℝ^3
θ ∈ ℝ
v ∈ ℝ
`D_A` ∈ ℝ,ℝ → ℝ^3
δ ∈ ℝ,ℝ → ℝ""",
    [
        fixed_vector(vec[0]),
        fixed_vector(vec[1]),
        fixed_vector(vec[2]),
        fixed_vector(vec[3]),
        fixed_vector(vec[4]),
        real(a),
        real(b),
        rust("|t: f64, v: f64| DVec3::new(t, v, 1.0)"),
        rust("|t: f64, v: f64| t + v"),
    ],
    x_θ_v=(
        lambda rr, nb, d, D: (rr @ D + (rr @ d) * (a + b))
        / (nb @ D + (nb @ d) * (a + b))
    )(
        np.cross(vec[0], vec[1]),
        np.cross(vec[2], vec[0]),
        vec[4] - vec[3],
        np.array([a, b, 1.0]),
    ),
)
Ms = [r(2, 3) for _ in range(3)]
vs = [r(3) for _ in range(3)]
us = [r(3) for _ in range(3)]
As = np.abs(r(3))
J = np.array([[0, -1], [1, 0.0]])
case(
    "conformal",
    """`E_{LSCM}` = ∑_T A_T ‖ M_T v_T - [0 -1
                                   1  0] M_T u_T ‖²
where
v_i ∈ ℝ^3
u_i ∈ ℝ^3
M_i ∈ ℝ^(2×3)
A_i ∈ ℝ""",
    [
        sequence([fixed_vector(x) for x in vs]),
        sequence([fixed_vector(x) for x in us]),
        sequence([fixed_matrix(x) for x in Ms]),
        sequence([real(x) for x in As]),
    ],
    E_LSCM=sum(A * nn(M @ v - J @ M @ u) ** 2 for A, M, v, u in zip(As, Ms, vs, us)),
)
case(
    "diagonal",
    "D_ii = w_i\ny = D w\nwhere\nw ∈ ℝ^n",
    [vector(n5)],
    D=np.diag(n5),
    y=n5 * n5,
)
case(
    "slices",
    "b = A_1,*\nc = A_*,2\nd = A_2,3\nwhere\nA ∈ ℝ^(m×n)",
    [matrix(M45)],
    b=M45[0],
    c=M45[:, 1],
    d=M45[1, 2],
)
case(
    "nested_index",
    "b = ∑_i x_(k_i)\nwhere\nx ∈ ℝ^n\nk_i ∈ ℤ",
    [vector(n5), sequence([integer(2), integer(5), integer(2)])],
    b=n5[1] * 2 + n5[4],
)
xx = 0.35
case(
    "trigonometric",
    """sin, cos, tan, asin, acos, atan, arcsin, arccos, arctan, sinh, cosh, tanh, asinh, acosh, atanh, arsinh, arcosh, artanh, cot, sec, csc, atan2 from trigonometry
b = sin(a) + cos(a) + tan(a) + asin(a) + acos(a) + atan(a)
c = arcsin(a) + arccos(a) + arctan(a) + sinh(a) + cosh(a)+tanh(a)
d = asinh(a) + acosh(1+a) + atanh(a) + arsinh(a)+arcosh(1 + a)+artanh(a)
f = cot(a)+sec(a)+csc(a)+atan2(a, -2a)
where
a ∈ ℝ""",
    [real(xx)],
    b=math.sin(xx)
    + math.cos(xx)
    + math.tan(xx)
    + math.asin(xx)
    + math.acos(xx)
    + math.atan(xx),
    c=math.asin(xx)
    + math.acos(xx)
    + math.atan(xx)
    + math.sinh(xx)
    + math.cosh(xx)
    + math.tanh(xx),
    d=2 * (math.asinh(xx) + math.acosh(1 + xx) + math.atanh(xx)),
    f=1 / math.tan(xx) + 1 / math.cos(xx) + 1 / math.sin(xx) + math.atan2(xx, -2 * xx),
)
case(
    "trigonometric_entries",
    "sin from trigonometry\nb = sin(A)\nc = sin²(a) + sin^2(a)\nwhere\nA ∈ ℝ^(m×n)\na ∈ ℝ",
    [matrix(M45), real(a)],
    b=np.sin(M45),
    c=2 * math.sin(a) ** 2,
)
case(
    "exponentials",
    "e from trigonometry\nb = e^2 + log(a) + ln(a) + log_2(a) + log_10(a) + log₂(a) + exp(a) + √a + sqrt(a)\nwhere\na ∈ ℝ",
    [real(a)],
    b=math.e**2
    + 2 * math.log(a)
    + 2 * math.log2(a)
    + math.log10(a)
    + math.exp(a)
    + 2 * math.sqrt(a),
)
case(
    "linear_algebra_functions",
    """trace, tr, diag, vec, det, rank, inv from linearalgebra
a = trace(A)
b = tr(A)
c = diag(A)
d = vec(A)
f = det(A)
g = rank(A)
h = inv(A)
where
A ∈ ℝ^(n×n)""",
    [matrix(S4)],
    a=np.trace(S4),
    b=np.trace(S4),
    c=np.diag(S4),
    d=S4.flatten("F"),
    f=np.linalg.det(S4),
    g=4,
    h=inv(S4),
)
case(
    "diagonal_of_vector",
    "diag from linearalgebra\nD = diag(x)\nwhere\nx ∈ ℝ^n",
    [vector(n5)],
    D=np.diag(n5),
)
case(
    "chain",
    "a = b + 1\nc = a b\nd = a c\nwhere\nb ∈ ℝ",
    [real(b)],
    d=(b + 1) * (b + 1) * b,
)
case("bare", "a + b\nwhere\na, b ∈ ℝ", [real(a), real(b)], ret=a + b)
case(
    "greek",
    "θ = α β + γ\nwhere\nα, β, γ ∈ ℝ",
    [real(a), real(b), real(c)],
    theta=a * b + c,
)
case(
    "integers",
    "c = a b + 2\nd = a/b\nwhere\na, b ∈ ℤ",
    [integer(3), integer(4)],
    c=14,
    d=0.75,
)
case(
    "integer_vectors",
    "c = a + b\nwhere\na, b ∈ ℤ^n",
    [integer_vector([1, 2, 3]), integer_vector([4, 5, 6])],
    c=np.array([5, 7, 9]),
)
i1 = np.array([[1, 2, 3], [4, 5, 6]])
i2 = np.array([[1, 0], [2, 1], [0, 3]])
case(
    "integer_matrices",
    "C = A B\nwhere\nA ∈ ℤ^(2×3)\nB ∈ ℤ^(3×2)",
    [integer_matrix(i1), integer_matrix(i2)],
    C=i1 @ i2,
)
case(
    "sequence_definition",
    "y_i = A x_i\nwhere\nA ∈ ℝ^(3×3)\nx_i ∈ ℝ^3",
    [fixed_matrix(A3), SX],
    y=[A3 @ x for x in xs],
)
case(
    "sequence_of_matrices",
    "B_i = A_i A_iᵀ\nwhere\nA_i ∈ ℝ^(2×3)",
    [sequence([fixed_matrix(x) for x in Ms])],
    B=[x @ x.T for x in Ms],
)
case(
    "size_of",
    "n = #x\nm, k = #A\nwhere\nx ∈ ℝ^3\nA ∈ ℝ^(2×4)",
    [fixed_vector(u3), fixed_matrix(M45[:2, :4])],
    n=3,
    m=2,
    k=4,
)
case(
    "set_sum",
    "b = ∑_(i ∈ S) i\nc = |S|\nwhere\nS ∈ {ℤ}",
    [integer_set([1, 5, 7])],
    b=13,
    c=3,
)
case(
    "pair_sum",
    "b = ∑_((i,j) ∈ S) i j\nwhere\nS ∈ {ℤ×ℤ}",
    [pairs([(1, 2), (3, 4)])],
    b=14,
)
case(
    "pair_entries",
    "b = ∑_(i,j ∈ S) A_i,j\nwhere\nS ∈ {ℤ×ℤ}\nA ∈ ℝ^(n×n)",
    [pairs([(1, 2), (3, 4)]), matrix(S4)],
    b=S4[0, 1] + S4[2, 3],
)
case(
    "set_filter",
    "b = ∑_(i for i ∈ S) x_i\nwhere\nS ∈ {ℤ}\nx ∈ ℝ^n",
    [integer_set([1, 3]), vector(n5)],
    b=n5[0] + n5[2],
)
case(
    "pair_filter",
    "b = ∑_i ∑_(j for (i,j) ∈ S) A_ij\nwhere\nS ∈ {ℤ×ℤ}\nA ∈ ℝ^(n×n)",
    [pairs([(1, 2), (3, 4)]), matrix(S4)],
    b=S4[0, 1] + S4[2, 3],
)
case(
    "ones",
    "y = 1_3ᵀ x\nz = 𝟙_n\nk = 0_n,m\nwhere\nx ∈ ℝ^3\nn, m ∈ ℤ",
    [fixed_vector(u3), integer(2), integer(3)],
    y=u3.sum(),
    z=np.ones(2),
    k=np.zeros((2, 3)),
)
case(
    "vector_literal",
    "y = (a, 2, b)\nz = (u, a)\nwhere\na, b ∈ ℝ\nu ∈ ℝ^3",
    [real(a), real(b), fixed_vector(u3)],
    y=[a, 2, b],
    z=[*u3, a],
)
case(
    "precedence",
    "y = 2a^2b/c - a/b c\nz = -a^2 + 1/2a\nwhere\na,b,c ∈ ℝ",
    [real(a), real(b), real(c)],
    y=2 * a**2 * b / c - a / b * c,
    z=-(a**2) + 0.5 * a,
)
case(
    "ascii",
    "y = sum_(i = 1)^n x_i^2 + `norm`\n`norm` = ||x||\nwhere\nx \\in RR^n",
    [vector(n5)],
    y=n5 @ n5 + nn(n5),
)
case("integral", "y = int_[0, 1] t^2 𝕕t", [], y=1 / 3)
case("integral_bounds", "y = ∫_0^1 a t^2 𝕕t\nwhere\na ∈ ℝ", [real(a)], y=a / 3)
case(
    "mean_normal_curvature",
    """`H(p)` = 1/(2π)int_[0, 2π] `kₙ`(φ, p) 𝕕φ
where
p ∈ ℝ^3 : point on the surface
`kₙ` ∈ ℝ,ℝ^3 → ℝ : normal curvature""",
    [
        fixed_vector(u3),
        rust("|t: f64, p: DVec3| t.cos().powi(2) * p.x + t.sin().powi(2) * p.y"),
    ],
    H_p=(u3[0] + u3[1]) / 2,
)
case("argmin", "y = argmin_(x ∈ ℝ) (x - a)^2\nwhere\na ∈ ℝ", [real(a)], y=a)
case(
    "rigid",
    "min_(C ∈ ℝ^3) ∑_i ‖x_i + (R_i - I_3)C‖²\nwhere\nx_i ∈ ℝ^3\nR_i ∈ ℝ^(3×3)",
    [SX, sequence([fixed_matrix(r(3, 3)) for _ in range(4)])],
)
Rs = cases[-1][2][1].value
case_rigid = cases.pop()
Ast = np.vstack([Rm - np.eye(3) for Rm in Rs])
bst = -np.concatenate(xs)
sol = np.linalg.lstsq(Ast, bst, rcond=None)[0]
case(
    "rigid",
    "min_(C ∈ ℝ^3) ∑_i ‖x_i + (R_i - I_3)C‖²\nwhere\nx_i ∈ ℝ^3\nR_i ∈ ℝ^(3×3)",
    case_rigid[2],
    ret=nn(Ast @ sol - bst) ** 2,
)
case(
    "rigid_argument",
    "C = argmin_(C ∈ ℝ^3) ∑_i ‖x_i + (R_i - I_3)C‖²\nwhere\nx_i ∈ ℝ^3\nR_i ∈ ℝ^(3×3)",
    case_rigid[2],
    C=sol,
)
case(
    "least_squares",
    "`x̂` = argmin_(x ∈ ℝ^n) ‖A x - b‖² \nwhere\nA ∈ ℝ^(m×n)\nb ∈ ℝ^m",
    [matrix(M45.T), vector(n5)],
    **{"x̂": np.linalg.lstsq(M45.T, n5, rcond=None)[0]}
)
E = [(0, 1), (1, 2), (0, 3), (1, 0)]
wm = np.abs(S4)
Lm = np.zeros((4, 4))
for i, j in E:
    Lm[i, j] = wm[i, j]
Lm -= np.diag(Lm.sum(1))
case(
    "laplacian",
    """L_i,j = { w_i,j if (i,j) ∈ E
          0 otherwise
L_i,i = -∑_(l for l ≠ i) L_i,l
where
w ∈ ℝ^(n×n): edge weight matrix
E ∈ {ℤ×ℤ} index: edges
n ∈ ℤ
L ∈ ℝ^(n×n)""",
    [matrix(wm), pairs(E), integer(4)],
    L=Lm,
)
K = np.zeros((4, 4))
d4 = r(4)
for i, j in [(1, 2), (2, 3), (3, 1)]:
    K[i - 1, j - 1] = d4[i - 1] + d4[j - 1]
K -= np.diag(K.sum(1))
case(
    "sparse_pairs",
    """P ∈ {ℤ×ℤ} : index pairs
n ∈ ℤ
K ∈ ℝ^(n×n)
d_i ∈ ℝ
K_ij = { d_i + d_j if (i,j) ∈ P
         0 otherwise
K_ii = -∑_(j for j != i) K_ij""",
    [pairs([(1, 2), (2, 3), (3, 1)]), integer(4), sequence([real(x) for x in d4])],
    K=K,
)
sp = np.zeros((4, 4))
sp[0, 1] = 1
sp[2, 2] = 1
case(
    "sparse_ones",
    "A_ij = { 1 if (i,j) ∈ P\n         0 otherwise\nwhere\nP ∈ {ℤ×ℤ}\nA ∈ ℝ^(4×4)",
    [pairs([(1, 2), (3, 3)])],
    A=sp,
)
case(
    "ragged",
    "b = ∑_i ‖x_i‖\nwhere\nx_i ∈ ℝ^(n_i)",
    [sequence([vector(n5), vector(u3)])],
    b=nn(n5) + nn(u3),
)
case(
    "expression_sizes",
    "y = A b\nwhere\nA ∈ ℝ^((n+1)×n)\nb ∈ ℝ^n",
    [matrix(M45.T[:4, :3]), vector(u3)],
    y=M45.T[:4, :3] @ u3,
)
case("tuples", "u, v = tuple(a, b)\nwhere\na, b ∈ ℝ", [real(a), real(b)], u=a, v=b)
case(
    "sequence_subscripts",
    "y = x_1 + x_2\nz = A_1,2\nw = B_1\nv = B_2,2,1\nwhere\nx ∈ ℝ^3\nA ∈ ℝ^(2×2)\nB_i ∈ ℝ^(2×2)",
    [
        fixed_vector(u3),
        fixed_matrix(A2),
        sequence([fixed_matrix(A2), fixed_matrix(B2)]),
    ],
    y=u3[0] + u3[1],
    z=A2[0, 1],
    w=A2,
    v=B2[1, 0],
)
case(
    "sum_entries_of_matrices",
    "s = ∑_i B_i,1,2\nwhere\nB_i ∈ ℝ^(2×2)",
    [sequence([fixed_matrix(A2), fixed_matrix(B2)])],
    s=A2[0, 1] + B2[0, 1],
)
case(
    "quotient_of_sums",
    "y = ∑_i x_i / ∑_i w_i\nwhere\nx, w ∈ ℝ^n",
    [vector(n5), vector(m5)],
    y=sum(x / m5.sum() for x in n5),
)
case(
    "quadratic_form",
    "y = uᵀ A v\nB = u vᵀ\nwhere\nu, v ∈ ℝ^n\nA ∈ ℝ^(n×n)",
    [vector(n5), vector(m5), matrix(S5)],
    y=n5 @ S5 @ m5,
    B=np.outer(n5, m5),
)
case(
    "pseudo_inverse",
    "y = A⁺ b\nP = A⁺\nwhere\nA ∈ ℝ^(m×n)\nb ∈ ℝ^m",
    [matrix(M45.T), vector(n5)],
    y=np.linalg.pinv(M45.T) @ n5,
    P=np.linalg.pinv(M45.T),
)
Sp = np.diag([1.0, 2, 3, 4])
Sp[0, 2] = 5
Sp[3, 1] = -1
case(
    "sparse_algebra",
    "y = A x\nB = A Aᵀ\nC = A + 2A - A∘A\nD = [A 0; 0 A]\nz = A \\ x\nwhere\nA ∈ ℝ^(n×n) sparse\nx ∈ ℝ^n",
    [sparse(Sp), vector(al)],
    y=Sp @ al,
    B=Sp @ Sp.T,
    C=3 * Sp - Sp * Sp,
    D=np.block([[Sp, 0 * Sp], [0 * Sp, Sp]]),
    z=np.linalg.solve(Sp, al),
)
case(
    "words",
    "y = scalar1 + v_1\nwhere\nscalar1: scalar\nv: vector(n)",
    [real(a), vector(n5)],
    y=a + n5[0],
)
case(
    "least_and_greatest",
    "y = min(a, b) + max(a,b,3)\nz = min(S) + max(x)\nwhere\na,b ∈ ℝ\nS ∈ {ℝ}\nx ∈ ℝ^n",
    [real(a), real(b), real_set([1.5, -2.0]), vector(n5)],
    y=min(a, b) + 3,
    z=-2 + n5.max(),
)
case("set_literal", "S = {1, 2, a}\ny = |S|\nwhere\na ∈ ℤ", [integer(2)], y=2, S=[1, 2])
case(
    "fractions",
    "y = ½a + ¾ + 2/3 a\nwhere\na ∈ ℝ",
    [real(a)],
    y=0.5 * a + 0.75 + 2 / 3 * a,
)
case(
    "bars",
    "y = |a|b|c| + ||u||||v|| + |a||b|\nwhere\na,b,c ∈ ℝ\nu, v ∈ ℝ^3",
    [real(a), real(b), real(c), fixed_vector(u3), fixed_vector(v3)],
    y=abs(a) * b * abs(c) + nn(u3) * nn(v3) + abs(a * b),
)
case(
    "mixed_program",
    """a, b ∈ ℝ^n
y = aᵀb + ||a||_1
w_i = a_i b_i
t = { y if y > 0
      -y otherwise
G(x, k) = x^k + clip(x) where x ∈ ℝ, k ∈ ℤ
clip(x) = min(max(x, 0), 1) where x ∈ ℝ
z = G(y, 2)
S ∈ {ℤ}
u, v = tuple(∑_(i ∈ S) w_i, |S|)
odd = { k+1 for k ∈ S if k > 2 and k < 9 }
Q = (S ∪ odd) \\ S""",
    [vector(n5), vector(m5), integer_set([1, 3, 4])],
    y=n5 @ m5 + nn(n5, 1),
    t=abs(n5 @ m5 + nn(n5, 1)),
    z=(lambda y: y * y + min(max(y, 0), 1))(n5 @ m5 + nn(n5, 1)),
    u=sum((n5 * m5)[[0, 2, 3]]),
    v=3,
    odd=[4, 5],
    Q=[5],
)
case(
    "single_entries",
    "y_1 = a\ny_2 = b\ny ∈ ℝ^3\nwhere\na,b ∈ ℝ",
    [real(a), real(b)],
    y=[a, b, 0],
)
case("add_to", "y_i = x_i\ny_i += 2x_i\nwhere\nx ∈ ℝ^n", [vector(n5)], y=3 * n5)
case("entries_of_row", "P_i,* = x_i\nwhere\nx_i ∈ ℝ^3", [SX], P=np.array(xs))
case("entries_of_column", "P_*,i = x_i\nwhere\nx_i ∈ ℝ^3", [SX], P=np.array(xs).T)
case(
    "triple_sum",
    "y = ∑_i ∑_j ∑_k A_ij B_jk C_ki\nwhere\nA,B,C ∈ ℝ^(3×3)",
    [fixed_matrix(A3), fixed_matrix(B3), fixed_matrix(C3)],
    y=np.trace(A3 @ B3 @ C3),
)
case("constrained", "y = min_(x ∈ ℝ^2) ‖x‖² s.t. x_1 ≥ 1", [], y=1.0)
q2 = spd(2)
case(
    "simplex",
    """y = argmin_(x ∈ ℝ^n) xᵀ A x + bᵀ x
s.t.
x ≥ 0
∑_i x_i = 1
where
A ∈ ℝ^(n×n)
b ∈ ℝ^n""",
    [matrix(S4), vector(al)],
    y=optimize.minimize(
        lambda x: x @ S4 @ x + al @ x,
        np.ones(4) / 4,
        constraints=[{"type": "eq", "fun": lambda x: x.sum() - 1}],
        bounds=[(0, None)] * 4,
        method="SLSQP",
        options=dict(ftol=1e-14, maxiter=1000),
    ).x,
)
case(
    "unit_vectors",
    "n(u) = u/‖u‖ where u ∈ ℝ^3\ny = n(a) × n(b)\na, b ∈ ℝ^3",
    [fixed_vector(u3), fixed_vector(v3)],
    y=np.cross(u3 / nn(u3), v3 / nn(v3)),
)
case(
    "product_of_sequence",
    "y = ∏_i w_i\nz = ∏_(i = 1)^4 i\nwhere\nw ∈ ℝ^n",
    [vector(n5)],
    y=n5.prod(),
    z=24,
)
case(
    "factorial",
    "g(k) = { 1 if k < 1\n         k g(k-1) otherwise\nwhere k ∈ ℤ\ny = g(5)",
    [],
    y=120,
)
case(
    "overloads",
    "f(x) = x² where x ∈ ℝ\nf(x) = ‖x‖ where x ∈ ℝ^3\ny = f(a) + f(u)\na ∈ ℝ\nu ∈ ℝ^3",
    [real(a), fixed_vector(u3)],
    y=a * a + nn(u3),
)
case(
    "ranges",
    "y = ∑_(k=1)^n ∑_(j=k)^n A_k,j\nwhere\nA ∈ ℝ^(n×n)",
    [matrix(S5)],
    y=np.triu(S5).sum(),
)
case(
    "sum_where",
    "y = ∑_i s where s = x_i² + 1\nwhere\nx ∈ ℝ^n",
    [vector(n5)],
    y=(n5**2 + 1).sum(),
)
case(
    "ternary",
    "y = { a if a > b and b > 0 or c = 2.25\n  b otherwise\nwhere\na,b,c ∈ ℝ",
    [real(a), real(b), real(c)],
    y=a,
)
case(
    "vector_of_vectors",
    "y = (u, 2v, 1)\nwhere\nu,v ∈ ℝ^3",
    [fixed_vector(u3), fixed_vector(v3)],
    y=[*u3, *(2 * v3), 1],
)
case(
    "trace_product",
    "y = tr(A^T A)\ntr from linearalgebra\nwhere\nA ∈ ℝ^(m×n)",
    [matrix(M45)],
    y=(M45**2).sum(),
)
case(
    "scalar_matrix",
    "y = 2A/3 - A a\nwhere\nA ∈ ℝ^(m×n)\na ∈ ℝ",
    [matrix(M45), real(a)],
    y=2 * M45 / 3 - a * M45,
)
case(
    "sum_of_set_values",
    "y = ∑_(x ∈ S) x²\nwhere\nS ∈ {ℝ}",
    [real_set([1.5, 2.5])],
    y=1.5**2 + 2.5**2,
)
case(
    "set_operations",
    "A = S ∪ W\nB = S ∩ W\nC = S \\ W\nD = S - W\nwhere\nS,W ∈ {ℤ}",
    [integer_set([1, 2, 3]), integer_set([2, 3, 4])],
    A=[1, 2, 3, 4],
    B=[2, 3],
    C=[1],
    D=[1],
)
case(
    "function_of_sequence",
    "L(q) = ∑_i ‖q_i‖ where q_i ∈ ℝ^3\ny = L(x)\nx_i ∈ ℝ^3",
    [SX],
    y=sum(nn(x) for x in xs),
)
case(
    "given_block",
    "given\nA ∈ ℝ^(2×2)\nb ∈ ℝ^2\ny = A b\ngiven\nc ∈ ℝ\nz = c y",
    [fixed_matrix(A2), fixed_vector(e1), real(c)],
    y=A2 @ e1,
    z=c * A2 @ e1,
)
case(
    "double_sum_weights",
    "y = ∑_i ∑_j w_ij ‖x_i - x_j‖²\nwhere\nw ∈ ℝ^(n×n)\nx_i ∈ ℝ^3",
    [matrix(S4), SX],
    y=sum(S4[i, j] * nn(xs[i] - xs[j]) ** 2 for i in range(4) for j in range(4)),
)
case(
    "infinity_piece",
    "y = { ∞ if a > 10\n ln(a) otherwise\nwhere\na ∈ ℝ",
    [real(a)],
    y=math.log(a),
)
case(
    "index_set_attribute",
    "y = ∑_(i ∈ S) x_i\nwhere\nS ∈ {ℤ} index\nx ∈ ℝ^n",
    [integer_set([0, 2]), vector(n5)],
    y=n5[0] + n5[2],
)
case(
    "index_parameter",
    "y = x_k\nwhere\nk ∈ ℤ index\nx ∈ ℝ^n",
    [integer(2), vector(n5)],
    y=n5[2],
)
case(
    "integer_parameter",
    "y = x_k\nwhere\nk ∈ ℤ\nx ∈ ℝ^n",
    [integer(2), vector(n5)],
    y=n5[1],
)
case(
    "named_size",
    "y = ∑_(i=1)^n x_i i\nz = n\nwhere\nx ∈ ℝ^n",
    [vector(n5)],
    y=sum((i + 1) * n5[i] for i in range(5)),
    z=5,
)
case(
    "row_vector_times",
    "y = [1 2 3] u\nz = [1;2;3]\nw = [1;2;3]ᵀ u\nwhere\nu ∈ ℝ^3",
    [fixed_vector(u3)],
    y=u3 @ [1, 2, 3],
    z=[1, 2, 3],
    w=u3 @ [1, 2, 3],
)
case(
    "column_plus_vector",
    "y = [1;2;3] + u\nwhere\nu ∈ ℝ^3",
    [fixed_vector(u3)],
    y=u3 + [1, 2, 3],
)
case(
    "multiline_matrix",
    "A = [a b\n     b c\n    ]\nwhere\na,b,c ∈ ℝ",
    [real(a), real(b), real(c)],
    A=np.array([[a, b], [b, c]]),
)
case(
    "negative_cells",
    "A = [a -b; -b a]\nB = [a - b]\nC = [a-b a]\nwhere\na,b ∈ ℝ",
    [real(a), real(b)],
    A=np.array([[a, -b], [-b, a]]),
    B=a - b,
    C=np.array([a - b, a]),
)
case(
    "bars_in_rows",
    "A = [|a| ||u||; 1 2]\nwhere\na ∈ ℝ\nu ∈ ℝ^3",
    [real(b), fixed_vector(u3)],
    A=np.array([[abs(b), nn(u3)], [1, 2]]),
)
case(
    "transpose_spellings",
    "A = B^T\nC = Bᵀ\nwhere\nB ∈ ℝ^(2×3)",
    [fixed_matrix(Ms[0])],
    A=Ms[0].T,
    C=Ms[0].T,
)
case(
    "subscript_digits",
    "y = x₁ + A₁,₂\nwhere\nx ∈ ℝ^3\nA ∈ ℝ^(2×2)",
    [fixed_vector(u3), fixed_matrix(A2)],
    y=u3[0] + A2[0, 1],
)
case("index_twelve", "y = w_12\nwhere\nw ∈ ℝ^13", [fixed_vector(np.arange(13.0))], y=11)
case("combining", "y = x̂ + n̄\nwhere\nx̂, n̄ ∈ ℝ", [real(a), real(b)], y=a + b)
case("splitting", "y = abc + cab\nwhere\nab, c ∈ ℝ", [real(a), real(b)], y=2 * a * b)
case("letters_product", "y = ab\nwhere\na, b ∈ ℝ", [real(a), real(b)], y=a * b)
case(
    "keywords_as_products",
    "y = a s + i f\nwhere\na,s,i,f ∈ ℝ",
    [real(1), real(2), real(3), real(4)],
    y=14,
)
case(
    "division_spellings",
    "y = a÷b + a/b\nwhere\na,b ∈ ℝ",
    [real(a), real(b)],
    y=2 * a / b,
)
case(
    "exponent_numbers",
    "y = 2E3 + 1.5E-2 + .5 + 3.\nz = 2E\nE = 3",
    [],
    y=2000 + 0.015 + 0.5 + 3,
    z=6,
)
case(
    "inequalities",
    "y = { 1 if a <= b\n 2 if a >= 10\n 3 if a ⩾ b and a ⩽ 2\n 4 otherwise\nwhere\na,b ∈ ℝ",
    [real(a), real(b)],
    y=3,
)
case(
    "colon_cases",
    "y = { 1 if k ∈ S\n 2 otherwise\nwhere\nk ∈ ℤ\nS ∈ {ℤ}",
    [integer(1), integer_set([1])],
    y=1,
)
case(
    "pair_condition",
    "y = { 1 if (i, j) ∈ P\n 2 otherwise\nwhere\ni, j ∈ ℤ\nP ∈ {ℤ×ℤ}",
    [integer(1), integer(2), pairs([(1, 2)])],
    y=1,
)
case("nuclear", "y = ‖A‖_*\nwhere\nA ∈ ℝ^(3×3)", [fixed_matrix(A3)], y=nn(A3, "nuc"))
case(
    "norm_of_difference", "y = ‖x_1 - x_2‖\nwhere\nx_i ∈ ℝ^3", [SX], y=nn(xs[0] - xs[1])
)
case(
    "inner_bracket_functions",
    "y = <f(a), u>\nwhere\nf ∈ ℝ → ℝ^3\na ∈ ℝ\nu ∈ ℝ^3",
    [rust("|x: f64| DVec3::new(x, 2.0 * x, 1.0)"), real(a), fixed_vector(u3)],
    y=np.array([a, 2 * a, 1]) @ u3,
)
case(
    "function_power",
    "y = f(a)^2\nz = f(a)(b)\nwhere\nf ∈ ℝ → ℝ\na,b ∈ ℝ",
    [rust("|x: f64| x + 1.0"), real(a), real(b)],
    y=(a + 1) ** 2,
    z=(a + 1) * b,
)
case(
    "subscript_function",
    "g_k(x) = k x where k ∈ ℤ, x ∈ ℝ\ny = g_2(a) + g(3, a)\na ∈ ℝ",
    [real(a)],
    y=5 * a,
)
case(
    "functions_with_subscripts_only",
    "h_i,j = i + 2j where i, j ∈ ℤ\ny = h_1,2 + h(3,4)",
    [],
    y=5 + 11,
)
case(
    "locals",
    "f(x) = s + t where x ∈ ℝ, s = x², t = s + 1\ny = f(a)\na ∈ ℝ",
    [real(a)],
    y=2 * a * a + 1,
)
case(
    "locals_next_line",
    "f(x) = s t\n where x ∈ ℝ, s = x²,\n t = 3\ny = f(a)\na ∈ ℝ",
    [real(a)],
    y=3 * a * a,
)
case(
    "function_vector_result",
    "f(x) = (x, x², 1) where x ∈ ℝ\ny = f(a)\nz = y_2\na ∈ ℝ",
    [real(a)],
    y=[a, a * a, 1],
    z=a * a,
)
case(
    "piecewise_function",
    "f(x) = { x if x > 0\n         -x otherwise\nwhere x ∈ ℝ\ny = f(a) + f(b)\na,b ∈ ℝ",
    [real(a), real(b)],
    y=a - b,
)
case(
    "matrix_of_functions",
    "sin, cos from trigonometry\nR(t) = [cos(t) -sin(t)\n        sin(t) cos(t)] where t ∈ ℝ\ny = R(a) u\na ∈ ℝ\nu ∈ ℝ^2",
    [real(a), fixed_vector(e1)],
    y=np.array([[math.cos(a), -math.sin(a)], [math.sin(a), math.cos(a)]]) @ e1,
)
case(
    "sequence_functions",
    "d(p, q) = ‖p - q‖ where p, q ∈ ℝ^n\ny = ∑_i ∑_j d(x_i, x_j)\nx_i ∈ ℝ^3",
    [SX],
    y=sum(nn(p - q) for p in xs for q in xs),
)
case(
    "set_of_vectors",
    "y = ∑_(v ∈ S) ‖v‖\nwhere\nS ∈ {ℝ^(3)}",
    [rust("Set::from_iter([DVec3::new(3.0, 4.0, 0.0), DVec3::new(0.0, 5.0, 12.0)])")],
    y=18,
)
case(
    "set_of_triples",
    "y = ∑_(i,j,k ∈ S) i j k\nwhere\nS ∈ {ℤ^3}",
    [rust("Set::from_iter([(1_i64, 2_i64, 3_i64), (2, 2, 2)])")],
    y=14,
)
case(
    "tuple_parameter", "y = a_1 + a_2\nwhere\na ∈ ℝ × ℤ", [rust("(1.5, 2_i64)")], y=3.5
)
case("destructure_set", "a, b = S\nwhere\nS ∈ {ℤ}", [integer_set([4, 2])], a=2, b=4)
case(
    "destructure_vector",
    "a, b, c = u\nwhere\nu ∈ ℝ^3",
    [fixed_vector(u3)],
    a=u3[0],
    b=u3[1],
    c=u3[2],
)
case(
    "svd_values",
    "svd from linearalgebra\nU, s, W = svd(A)\nwhere\nA ∈ ℝ^(3×3)",
    [fixed_matrix(A3)],
    s=np.linalg.svd(A3)[1],
)
Kr = np.array([[1.0, 2, 3], [2, 4, 6]])
case(
    "null_space",
    "null from linearalgebra\nN = null(A)\ny = ‖A N‖\nz = ‖Nᵀ N - I_2‖\nwhere\nA ∈ ℝ^(2×3)",
    [fixed_matrix(Kr)],
    y=0,
)
case(
    "orthogonal_basis",
    "orth from linearalgebra\nN = orth(A)\ny = ‖N Nᵀ A - A‖\nwhere\nA ∈ ℝ^(2×3)",
    [fixed_matrix(Kr)],
    y=0,
)
case(
    "inverse_vec",
    "vec, vec⁻¹ from linearalgebra\ny = vec⁻¹_x(2 vec(x))\nwhere\nx_i ∈ ℝ^3",
    [SX],
    y=[2 * x for x in xs],
)
case(
    "positive_part",
    "psd from linearalgebra\nB = psd(A)\nwhere\nA ∈ ℝ^(3×3)",
    [fixed_matrix((A3 + A3.T) / 2)],
    B=(lambda w, Q: Q @ np.diag(np.maximum(w, 0)) @ Q.T)(
        *np.linalg.eigh((A3 + A3.T) / 2)
    ),
)
case(
    "rectangular_diag",
    "diag from linearalgebra\nD = diag(x, 3, 4)\nwhere\nx ∈ ℝ^3",
    [fixed_vector(u3)],
    D=np.hstack([np.diag(u3), np.zeros((3, 1))]),
)
case(
    "identity_named", "y = I_n + A\nwhere\nA ∈ ℝ^(n×n)", [matrix(S4)], y=np.eye(4) + S4
)
case(
    "own_identity_symbol", "y = I A\nI = 3\nwhere\nA ∈ ℝ^(n×n)", [matrix(S4)], y=3 * S4
)
case(
    "own_transpose_letter",
    "y = A^T A + T I_2\nT = 2\nwhere\nA ∈ ℝ^(2×2)",
    [fixed_matrix(A2)],
    y=A2.T @ A2 + 2 * np.eye(2),
)
case(
    "left_associative",
    "y = a/b c + a - b - c\nwhere\na,b,c ∈ ℝ",
    [real(a), real(b), real(c)],
    y=a / b * c + a - b - c,
)
case(
    "power_tower", "y = 2^a^b + 2^(a+1)\nwhere\na,b ∈ ℝ", [real(2), real(3)], y=2**8 + 8
)
case(
    "power_juxtaposed",
    "y = a²b + a^2b\nwhere\na,b ∈ ℝ",
    [real(a), real(b)],
    y=2 * a * a * b,
)
case(
    "power_then_cross",
    "y = a^2 u × v\nwhere\na ∈ ℝ\nu,v ∈ ℝ^3",
    [real(a), fixed_vector(u3), fixed_vector(v3)],
    y=a * a * np.cross(u3, v3),
)
case(
    "triple_product",
    "y = u × v ⋅ w\nz = w⋅(u × v)\nwhere\nu,v,w ∈ ℝ^3",
    [fixed_vector(u3), fixed_vector(v3), fixed_vector(w3)],
    y=np.cross(u3, v3) @ w3,
    z=np.cross(u3, v3) @ w3,
)
case(
    "sqrt_forms",
    "y = √a b + √(a b) + sqrt(a)\nwhere\na,b ∈ ℝ",
    [real(4), real(9)],
    y=2 * 9 + 6 + 2,
)
case(
    "sum_of_negatives",
    "y = ∑_i -w_i a\nwhere\nw_i ∈ ℝ\na ∈ ℝ",
    [sequence(sw), real(a)],
    y=-a * n5.sum(),
)
case(
    "sum_divided",
    "y = ∑_i w_i a / b + 1\nwhere\nw_i ∈ ℝ\na,b ∈ ℝ",
    [sequence(sw), real(a), real(b)],
    y=a * n5.sum() / b + 1,
)
case(
    "empty_sum",
    "y = ∑_(i ∈ S) i\nz = ∑_(i=3)^2 i\nwhere\nS ∈ {ℤ}",
    [rust("Set::<i64>::from_iter([])")],
    y=0,
    z=0,
)
case(
    "sum_over_union",
    "y = ∑_(k ∈ S ∪ W) k + ∑_(k ∈ {1,2}) k\nwhere\nS,W ∈ {ℤ}",
    [integer_set([1]), integer_set([1, 5])],
    y=6 + 3,
)
case(
    "builder_forms",
    "A = {k | k ∈ S, k > 2}\nB = {2k for k ∈ S if k > 2}\nC = {k ∀ k ∈ S}\nwhere\nS ∈ {ℤ}",
    [integer_set([1, 3, 4])],
    A=[3, 4],
    B=[6, 8],
    C=[1, 3, 4],
)
case(
    "builder_pairs",
    "A = {i + j for i,j ∈ S if i < j}\nwhere\nS ∈ {ℤ×ℤ}",
    [pairs([(1, 2), (4, 3)])],
    A=[3],
)
case(
    "set_comparison",
    "y = { 1 if S = W\n 0 otherwise\nwhere\nS,W ∈ {ℤ}",
    [integer_set([1, 2]), integer_set([2, 1])],
    y=1,
)
case("set_item", "y = S_1\nwhere\nS ∈ {ℤ}", [integer_set([5, 3])], y=3)
case(
    "sum_with_condition_set",
    "y = ∑_(i for i ∈ S and i > 1) x_i\nwhere\nS ∈ {ℤ}\nx ∈ ℝ^n",
    [integer_set([1, 3]), vector(n5)],
    y=n5[2],
)
case(
    "matrix_by_scalar_function",
    "A_ij = f(i, j)\nf(i,j) = i + 10j where i,j ∈ ℤ\nA ∈ ℝ^(2×3)",
    [],
    A=np.array([[11, 21, 31], [12, 22, 32]]),
)
case(
    "diagonal_then_entries",
    "y_i = A_ii\nwhere\nA ∈ ℝ^(n×n)",
    [matrix(S4)],
    y=np.diag(S4),
)
case("trace_by_sum", "y = ∑_i A_ii\nwhere\nA ∈ ℝ^(n×n)", [matrix(S4)], y=np.trace(S4))
case(
    "shifted_sum",
    "y = ∑_(i for i < n) (x_i - x_(i+1))²\nwhere\nx ∈ ℝ^n\nn ∈ ℤ",
    [vector(n5), integer(5)],
    y=sum((n5[i] - n5[i + 1]) ** 2 for i in range(4)),
)
case(
    "block_of_vectors",
    "A = [u v]\nB = [uᵀ; vᵀ]\nwhere\nu,v ∈ ℝ^3",
    [fixed_vector(u3), fixed_vector(v3)],
    A=np.column_stack([u3, v3]),
    B=np.vstack([u3, v3]),
)
case(
    "zero_block_named",
    "B = [A 0_n,m; 0_m,n I_m]\nwhere\nA ∈ ℝ^(n×n)\nm ∈ ℤ",
    [matrix(S4), integer(2)],
    B=np.block([[S4, np.zeros((4, 2))], [np.zeros((2, 4)), np.eye(2)]]),
)
case(
    "size_product",
    "y = vec(A)\nvec from linearalgebra\nwhere\nA ∈ ℝ^(n×m)",
    [matrix(M45)],
    y=M45.flatten("F"),
)
case(
    "cross_of_sums",
    "y = (u + v) × (u - v)\nwhere\nu,v ∈ ℝ^3",
    [fixed_vector(u3), fixed_vector(v3)],
    y=np.cross(u3 + v3, u3 - v3),
)
case(
    "registration",
    "q = ∑_i ‖R x_i + t - y_i‖²\nwhere\nR ∈ ℝ^(3×3)\nt ∈ ℝ^3\nx_i ∈ ℝ^3\ny_i ∈ ℝ^3",
    [fixed_matrix(A3), fixed_vector(u3), SX, sequence([fixed_vector(p) for p in ps])],
    q=sum(nn(A3 @ x + u3 - p) ** 2 for x, p in zip(xs, ps)),
)
case(
    "normal_equations",
    "x = (AᵀA)⁻¹Aᵀb\nz = (AᵀA)⁻¹(Aᵀb)\nwhere\nA ∈ ℝ^(m×n)\nb ∈ ℝ^m",
    [matrix(M45.T), vector(n5)],
    x=np.linalg.lstsq(M45.T, n5, rcond=None)[0],
    z=np.linalg.lstsq(M45.T, n5, rcond=None)[0],
)
case(
    "kalman",
    "K = P Hᵀ (H P Hᵀ + R)⁻¹\nQ = (I_4 - K H) P\nwhere\nP ∈ ℝ^(4×4)\nH ∈ ℝ^(2×4)\nR ∈ ℝ^(2×2)",
    [fixed_matrix(S4), fixed_matrix(M45[:2, :4]), fixed_matrix(spd(2))],
)
Hk = M45[:2, :4]
Rk = cases[-1][2][2].value
Kk = S4 @ Hk.T @ inv(Hk @ S4 @ Hk.T + Rk)
cases[-1] = cases[-1][:3] + ({"K": Kk, "Q": (np.eye(4) - Kk @ Hk) @ S4},)
case(
    "lagrangian",
    "y = ½ ‖x‖² + λᵀ(A x - b) + ρ/2 ‖A x - b‖²\nwhere\nx ∈ ℝ^n\nλ ∈ ℝ^m\nA ∈ ℝ^(m×n)\nb ∈ ℝ^m\nρ ∈ ℝ",
    [vector(n5), vector(al), matrix(M45), vector(px), real(3)],
    y=0.5 * n5 @ n5 + al @ (M45 @ n5 - px) + 1.5 * nn(M45 @ n5 - px) ** 2,
)
case(
    "softmax",
    "s_i = exp(x_i)/∑_j exp(x_j)\nwhere\nx ∈ ℝ^n",
    [vector(n5)],
    s=np.exp(n5) / np.exp(n5).sum(),
)
case(
    "gaussian",
    "p = exp(-½ (x - μ)ᵀΣ⁻¹(x - μ))/√((2π)^n |Σ|)\nwhere\nx, μ ∈ ℝ^n\nΣ ∈ ℝ^(n×n)",
    [vector(n5), vector(m5), matrix(S5)],
    p=math.exp(-0.5 * (n5 - m5) @ inv(S5) @ (n5 - m5))
    / math.sqrt((2 * math.pi) ** 5 * np.linalg.det(S5)),
)
case(
    "householder",
    "H = I_n - 2 (v vᵀ)/(vᵀv)\ny = H x\nwhere\nv, x ∈ ℝ^n",
    [vector(n5), vector(m5)],
    y=m5 - 2 * n5 * (n5 @ m5) / (n5 @ n5),
)
case(
    "skew",
    "S = [0 -u_3 u_2; u_3 0 -u_1; -u_2 u_1 0]\ny = S v\nwhere\nu,v ∈ ℝ^3",
    [fixed_vector(u3), fixed_vector(v3)],
    y=np.cross(u3, v3),
)
case(
    "arap",
    "E = ∑_i ∑_j w_ij ‖(p_i - p_j) - R_i(q_i - q_j)‖²\nwhere\nw ∈ ℝ^(n×n)\np_i,q_i ∈ ℝ^3\nR_i ∈ ℝ^(3×3)",
    [
        matrix(S4),
        SX,
        sequence([fixed_vector(p) for p in ps]),
        sequence([fixed_matrix(x) for x in Rs]),
    ],
    E=sum(
        S4[i, j] * nn(xs[i] - xs[j] - Rs[i] @ (ps[i] - ps[j])) ** 2
        for i in range(4)
        for j in range(4)
    ),
)
case(
    "names_with_backticks",
    "`my name` = 2`x*` + `a_b`\nwhere\n`x*` ∈ ℝ\n`a_b` ∈ ℝ",
    [real(a), real(b)],
    my_name=2 * a + b,
)
case(
    "parenthesised_index",
    "y = A_(i+1,2) + x_(n-1)\ni = 1\nwhere\nA ∈ ℝ^(2×2)\nx ∈ ℝ^n",
    [fixed_matrix(A2), vector(n5)],
    y=A2[1, 1] + n5[3],
)
case(
    "entries_with_sizes",
    "A_ij = x_i y_j\nwhere\nx ∈ ℝ^n\ny ∈ ℝ^m",
    [vector(n5), vector(al)],
    A=np.outer(n5, al),
)
case("semicolon_items", "a = 1; b = a + 1; c = b²", [], c=4)
case("comment", "// a comment\na = 1 // another\nb = 2a", [], b=2)
case("break_after_operator", "y = a +\n b\nwhere\na,b ∈ ℝ", [real(a), real(b)], y=a + b)
case(
    "breaks_in_parentheses",
    "y = (a\n + b)\nwhere\na,b ∈ ℝ",
    [real(a), real(b)],
    y=a + b,
)
case(
    "sum_inside_norm",
    "y = ‖∑_i x_i‖²/∑_i ‖x_i‖²\nwhere\nx_i ∈ ℝ^3",
    [SX],
    y=nn(sum(xs)) ** 2 / sum(x @ x for x in xs),
)
case(
    "function_of_matrix_any",
    "f(A) = tr(A) where A ∈ ℝ^(n×n)\ntr from linearalgebra\ny = f(B) + f(C)\nB ∈ ℝ^(2×2)\nC ∈ ℝ^(3×3)",
    [fixed_matrix(A2), fixed_matrix(C3)],
    y=np.trace(A2) + np.trace(C3),
)
case("mutual_order", "c = a + b\nb = 2a\na = 3", [], c=9)
case(
    "int_mapping",
    "y = ∑_i k_i x_i\nwhere\nk_i ∈ ℤ\nx_i ∈ ℝ",
    [sequence([integer(1), integer(2)]), sequence([real(a), real(b)])],
    y=a + 2 * b,
)
case(
    "vector_index_vector",
    "y_i = x_(k_i)\nwhere\nx ∈ ℝ^n\nk_i ∈ ℤ",
    [vector(n5), sequence([integer(2), integer(5)])],
    y=[n5[1], n5[4]],
)
case(
    "det_of_literal",
    "y = |[a b; c a]|\nz = |[u v w]|\nwhere\na,b,c ∈ ℝ\nu,v,w ∈ ℝ^3",
    [real(a), real(b), real(c), fixed_vector(u3), fixed_vector(v3), fixed_vector(w3)],
    y=a * a - b * c,
    z=np.linalg.det(np.column_stack([u3, v3, w3])),
)
case("mod_free", "y = log_2(8) + log_10(100) + ln(1)", [], y=5)
case("pi", "y = 2π r\nwhere\nr ∈ ℝ", [real(a)], y=2 * math.pi * a)
case(
    "sequence_of_sequences",
    "y = ∑_i ∑_j x_i,j\nwhere\nx_i ∈ ℝ^3",
    [SX],
    y=sum(x.sum() for x in xs),
)
case(
    "min_of_expression",
    "y = min({‖x_i‖ for i ∈ S})\nwhere\nS ∈ {ℤ}\nx_i ∈ ℝ^3",
    [integer_set([1, 2, 3, 4]), SX],
    y=min(nn(x) for x in xs),
)
case(
    "argmin_set",
    "y = argmin_(i ∈ S) x_i\nwhere\nS ∈ {ℤ}\nx ∈ ℝ^n",
    [integer_set([1, 2, 3, 4, 5]), vector(n5)],
    y=int(n5.argmin()) + 1,
)
case("max_box", "y = max_(x ∈ ℝ) x (1 - x) s.t. x ≥ 0; x ≤ 1", [], y=0.25)
case("rosenbrock", "y = argmin_(x ∈ ℝ^2) (1 - x_1)² + 100(x_2 - x_1²)²", [], y=[1, 1])
case("two_variables", "y = min_(a ∈ ℝ, b ∈ ℝ) (a - 1)² + (b + 2)² + 3", [], y=3)
case("sine_integral", "sin from trigonometry\ny = ∫_[0, π] sin(t) 𝕕t", [], y=2)
case("nested_integral", "y = ∫_0^1 ∫_0^2 s t 𝕕s 𝕕t", [], y=1)
case(
    "integral_expression",
    "sin from trigonometry\ny = 2 ∫_a^b t^2 + 1 𝕕t\nwhere\na,b ∈ ℝ",
    [real(0), real(3)],
    y=2 * (9 + 3),
)
case(
    "ragged_matrices",
    "y = ∑_i tr(A_iᵀ A_i)\ntr from linearalgebra\nwhere\nA_i ∈ ℝ^(m_i×n_i)",
    [sequence([matrix(M45), matrix(A2)])],
    y=(M45**2).sum() + (A2**2).sum(),
)
case(
    "sparse_declared_rows",
    """A ∈ ℝ^(n×n)
n ∈ ℤ
A_ij = { 1 if i = j
         0.5 if (i,j) ∈ P
P ∈ {ℤ×ℤ}
y = A x
x ∈ ℝ^n""",
    [integer(3), pairs([(1, 2)]), vector(u3)],
    y=(np.eye(3) + np.array([[0, 0.5, 0], [0, 0, 0], [0, 0, 0]])) @ u3,
)


def hofstadter_female(n):
    return 1 if n == 0 else n - hofstadter_male(hofstadter_female(n - 1))


def hofstadter_male(n):
    return 0 if n == 0 else n - hofstadter_female(hofstadter_male(n - 1))


case(
    "mutual_recursion",
    """A(n) = { 1 if n = 0
         n - B(A(n - 1)) otherwise where n ∈ ℤ
B(n) = { 0 if n = 0
         n - A(B(n - 1)) otherwise where n ∈ ℤ
y_i = A(k_i)
z_i = B(k_i)
k_i ∈ ℤ""",
    [sequence([integer(k) for k in (0, 1, 2, 5, 9)])],
    y=[hofstadter_female(k) for k in (0, 1, 2, 5, 9)],
    z=[hofstadter_male(k) for k in (0, 1, 2, 5, 9)],
)


def chained(n):
    return 1 if n == 0 else (chained(n - 1) + a * n) / 2


case(
    "recursion_in_a_circle",
    """f(n) = { 1 if n = 0
         g(n - 1, n)/2 otherwise where n ∈ ℤ
g(n, m) = h(n) + a m where n, m ∈ ℤ
h(n) = f(n) where n ∈ ℤ
y = f(4)
z = h(3)
a ∈ ℝ""",
    [real(a)],
    y=chained(4),
    z=chained(3),
)
case(
    "recursion_from_integer_to_real",
    "f(n) = { 1 if n = 0\n         f(n - 1)/2 + 1 otherwise where n ∈ ℤ\ny = f(3)",
    [],
    y=1.875,
)
case(
    "sizes_of_sequences",
    "k, r = #x\nl, s, t = #q\nn = #w\nm = |x|\np, u = #y\nwhere\nx_i ∈ ℝ³\nq_i ∈ ℝ^(2×c)\nw_i ∈ ℝ\ny_j ∈ ℝ^(d_j)",
    [
        SX,
        sequence([matrix(M45[:2]) for _ in xs]),
        SW,
        sequence([vector(n5), vector(u3)]),
    ],
    k=4,
    r=3,
    l=4,
    s=2,
    t=5,
    n=4,
    m=4,
    p=2,
    u=[5, 3],
)
case(
    "columns_and_vectors",
    """f(u) = u_1 + 2u_3 where u ∈ ℝ³
g(A) = A_1,1 + 2A_3,1 where A ∈ ℝ^(3×1)
h(A) = 2A_1,1 where A ∈ ℝ^(1×1)
k(a) = 2a where a ∈ ℝ
y = [1; 2; 3] + u
z = u - [1; 2; 3]
s = [a] + 1
t = f([1; 2; 3]) + g(u) + h(3) + k([4])
p = u
p_2 = [7]
p += [1; 1; 1]
r = { [1; 2; 3] if u_1 > 5
      u otherwise
where
u ∈ ℝ³
a ∈ ℝ""",
    [fixed_vector(u3), real(a)],
    y=u3 + [1, 2, 3],
    z=u3 - [1, 2, 3],
    s=a + 1,
    t=7 + u3[0] + 2 * u3[2] + 6 + 8,
    p=[u3[0] + 1, 8, u3[2] + 1],
    r=u3,
)
case(
    "matrix_before_vector",
    "f(A) = A_1,1 where A ∈ ℝ^(n×m)\nf(u) = u_1 + 10 where u ∈ ℝ^n\ny = f([a; b])\nz = f((a, b))\nwhere\na, b ∈ ℝ",
    [real(a), real(b)],
    y=a,
    z=a + 10,
)
case(
    "function_by_another_name",
    "g = f\nk = g\nψ = φ\ny = k(a) + ∑_i ψ_i(a)\nwhere\nf ∈ ℝ → ℝ\nφ_i ∈ ℝ → ℝ\na ∈ ℝ",
    [
        rust("|x: f64| x * x + 1.0"),
        rust("[(|x: f64| x) as fn(f64) -> f64, |x: f64| 3.0 * x]"),
        real(a),
    ],
    y=a * a + 1 + 4 * a,
)
case(
    "set_added_to",
    "T = S\nT += {7, 2}\nwhere\nS ∈ {ℤ}",
    [integer_set([2, 5])],
    T=[2, 5, 7],
)
case(
    "optima_in_cases",
    """y = { min_(t ∈ ℝ) (t - a)² + 1 if a > 2
      min_(t ∈ ℝ) (t - a)² + 2 s.t. t ≥ 3
      if a > 1
      0 otherwise
z = { argmin_(k ∈ ℤ) (k - b)²
        s.t. -3 ≤ k
             k ≤ 3
      otherwise
where
a, b ∈ ℝ""",
    [real(a), real(b)],
    y=(3 - a) ** 2 + 2,
    z=-1,
)
case(
    "ranked_overloads",
    """g(k) = 1 where k ∈ ℤ
g(k) = 2 where k ∈ ℝ
g(u) = 3 where u ∈ ℝ³
g(u) = 4 where u ∈ ℝ^n
h(k) = 1 + k where k ∈ ℝ
h(u) = 5 where u ∈ ℝ³
y = (g(1), g(1.5), g(p), g(q), h(2), h(p))
where
p ∈ ℝ³
q ∈ ℝ²""",
    [fixed_vector(u3), fixed_vector(e1)],
    y=[1, 2, 3, 4, 3, 5],
)

case(
    "functions_of_functions",
    """twice(g, x) = g(g(x)) where g ∈ ℝ → ℝ, x ∈ ℝ
y = twice(f, 3) + twice(p_1, 2) + ∑_i twice(p_i, 2)
newton(g, d, x, n) = { x if n = 0
                       newton(g, d, x - g(x)/d(x), n - 1) otherwise
where g ∈ ℝ → ℝ, d ∈ ℝ → ℝ, x ∈ ℝ, n ∈ ℤ
z = newton(f, p_2, 3, 6)
weighted(g, u) = ∑_i g(u) u_i where g ∈ ℝ^n → ℝ, u ∈ ℝ^n
w = weighted(h, v)
all(g, x) = ∑_i g_i(x) where g_i ∈ ℝ → ℝ, x ∈ ℝ
s = all(p, 2)
f ∈ ℝ → ℝ
p_i ∈ ℝ → ℝ
h ∈ ℝ^m → ℝ
v ∈ ℝ^m""",
    [
        rust("|x: f64| x * x - 2.0"),
        rust("vec![|x: f64| x + 1.0, |x: f64| 2.0 * x]"),
        rust("|x: DVector<f64>| x.sum()"),
        vector(u3),
    ],
    y=47 + 4 + 4 + 8,
    z=math.sqrt(2),
    w=u3.sum() ** 2,
    s=7,
    **{
        "twice(|x: f64| x + 1.0, 5.0)": 7,
        "all([|x: f64| x + 1.0, |x: f64| x + 2.0], 5.0)": 13,
    },
)
case(
    "sets_of_integers_and_reals",
    """U ∈ {ℤ}
S = { k² for k ∈ U if k > 1 }
T = { k | k ∈ U, k ≠ 3 }
A = S ∪ T
B = S ∩ T
C = T - {0.5}
q = { 1 if S = T
      2 if T ≠ S
f(s) = ∑_(k ∈ s) k/2 where s ∈ {ℝ}
r = f(U) + f(A)
D = { S if q > 1
      T otherwise
E = { {} if q > 1
      T otherwise""",
    [integer_set([1, 2, 3, 4])],
    A=[1, 2, 4, 9, 16],
    B=[4],
    C=[1, 2, 4],
    q=2,
    r=5 + 16,
    D=[4, 9, 16],
    E=[],
)
Q3 = np.array([[2.0, 1, 0], [0.5, 3, 1], [0, -0.4, 1.5]])
case(
    "roots_of_matrices",
    "B = A^(½)\nC = A^p\nD = A^(-0.5)\nE = B B\nwhere\nA ∈ ℝ^(3×3)\np ∈ ℝ",
    [fixed_matrix(Q3), real(2.3)],
    B=sl.fractional_matrix_power(Q3, 0.5).real,
    C=sl.fractional_matrix_power(Q3, 2.3).real,
    D=sl.fractional_matrix_power(Q3, -0.5).real,
    E=Q3,
)

# sums, sequences and sizes in further spellings
q6, p6 = r(6), r(6)
M66 = r(6, 6)
seq4 = [r(3) for _ in range(4)]
lens = [2, 3, 1, 4]
rag = [r(n) for n in lens]
rag_square = [r(n, n) for n in lens]
dyn = lambda items: sequence([vector(x) for x in items])
fix = lambda items: sequence([fixed_vector(x) for x in items])
reals = lambda items: sequence([real(x) for x in items])
Ssparse = np.round(spd(5) * (rng.uniform(size=(5, 5)) < 0.4), 3)
Ssparse = Ssparse + Ssparse.T + 9 * np.eye(5)
Tsparse = np.round(r(5, 5) * (rng.uniform(size=(5, 5)) < 0.5), 3)
case(
    "ragged_total",
    "s = ∑_i ∑_j x_i,j\nt = ∑_i ∑_(j = 1)^(n_i) j x_i,j\nwhere\nx_i ∈ ℝ^(n_i)",
    [dyn(rag)],
    s=sum(x.sum() for x in rag),
    t=sum((np.arange(1, len(x) + 1) * x).sum() for x in rag),
)
case(
    "ragged_systems",
    "y_i = A_i⁻¹ x_i\ns = ∑_i x_iᵀ A_i x_i\nwhere\nx_i ∈ ℝ^(n_i)\nA_i ∈ ℝ^(n_i×n_i)",
    [dyn(rag), sequence([matrix(A) for A in rag_square])],
    y=[np.linalg.solve(A, x) for A, x in zip(rag_square, rag)],
    s=sum(x @ A @ x for A, x in zip(rag_square, rag)),
)
case(
    "sum_over_set_and_later",
    "y = ∑_(i ∈ S) ∑_(j for j > i) a_i a_j\nwhere\nS ∈ {ℤ}\na_i ∈ ℝ",
    [integer_set([1, 3, 6]), reals(q6)],
    y=sum(q6[i - 1] * q6[j] for i in (1, 3, 6) for j in range(i, 6)),
)
case(
    "entries_in_set",
    "y_i = { a_i if i ∈ S\n        -1 otherwise\nwhere\na_i ∈ ℝ\nS ∈ {ℤ}",
    [reals(q6), integer_set([2, 5])],
    y=[q6[i] if i in (1, 4) else -1 for i in range(6)],
)
case(
    "matrix_by_order",
    "M_ij = { 1 if i = j\n         a_i a_j if i < j\n         0 otherwise\nwhere\na ∈ ℝ^n",
    [vector(q6)],
    M=np.triu(np.outer(q6, q6), 1) + np.eye(6),
)
case(
    "bidiagonal",
    "M ∈ ℝ^(n×n)\nM_ij = { 1 if i = j\n         a_i if j = i + 1\n         0 otherwise\ny = M a\nwhere\na ∈ ℝ^n",
    [vector(q6)],
    M=np.eye(6) + np.diag(q6[:5], 1),
    y=(np.eye(6) + np.diag(q6[:5], 1)) @ q6,
)
case(
    "triangular_sum",
    "y = ∑_(i=1)^n ∑_(j=1)^i A_ij\nwhere\nA ∈ ℝ^(n×n)",
    [matrix(M66)],
    y=np.tril(M66).sum(),
)
case(
    "signed_identity_blocks",
    "B = [I_m A; Aᵀ -I]\nC = [A 0_(m,2); 1_(2,n) [1 2; 3 4]]\nwhere\nA ∈ ℝ^(m×n)",
    [matrix(M45)],
    B=np.block([[np.eye(4), M45], [M45.T, -np.eye(5)]]),
    C=np.block([[M45, np.zeros((4, 2))], [np.ones((2, 5)), np.array([[1, 2], [3, 4]])]]),
)
case(
    "columns_over_their_sums",
    "y_i = ‖A_i,*‖\ns_j = ∑_i A_ij\nB_*,j = A_*,j / s_j\nz = B_*,1 + A_*,2\nwhere\nA ∈ ℝ^(m×n)",
    [matrix(M45)],
    y=np.linalg.norm(M45, axis=1),
    s=M45.sum(axis=0),
    B=M45 / M45.sum(axis=0),
    z=M45[:, 0] / M45[:, 0].sum() + M45[:, 1],
)
case(
    "weighted_covariance",
    "A = ∑_i w_i (x_i - μ)(x_i - μ)ᵀ\nμ = (∑_i w_i x_i) / ∑_i w_i\nwhere\nx_i ∈ ℝ^3\nw_i ∈ ℝ",
    [fix(seq4), reals(q6[:4])],
    A=sum(
        w * np.outer(x - m, x - m)
        for m in [sum(w * x for w, x in zip(q6, seq4)) / sum(q6[:4])]
        for w, x in zip(q6, seq4)
    ),
)
case(
    "vectorised_kronecker",
    "vec from linearalgebra\ny = (A ⊗ I_2) vec(B)\nz = vec(B Aᵀ)\nwhere\nA ∈ ℝ^(2×2)\nB ∈ ℝ^(2×2)",
    [fixed_matrix(A2), fixed_matrix(B2)],
    y=np.kron(A2, np.eye(2)) @ B2.flatten("F"),
    z=(B2 @ A2.T).flatten("F"),
)
case(
    "appended_one",
    "y = A (x, 1)\nz = A [x; 1]\nwhere\nA ∈ ℝ^(m×(n+1))\nx ∈ ℝ^n",
    [matrix(M45), vector(q6[:4])],
    y=M45 @ np.append(q6[:4], 1),
    z=M45 @ np.append(q6[:4], 1),
)
case(
    "rotation_about_axis",
    "R = I_3 + sin(θ) K + (1 - cos(θ)) K²\nK = [0 -k_3 k_2\n     k_3 0 -k_1\n     -k_2 k_1 0]\nsin, cos from trigonometry\nwhere\nk ∈ ℝ^3\nθ ∈ ℝ",
    [fixed_vector([0.6, 0.0, 0.8]), real(0.7)],
    R=sl.expm(0.7 * np.array([[0, -0.8, 0], [0.8, 0, -0.6], [0, 0.6, 0]])),
)
case(
    "difference_of_indices",
    "y = ∑_(i = 2)^n (a_i - a_(i-1))² + a_(n) a_1\nz = x_(b_2) + M_(b_1, 2) + x_(n-1)\nwhere\na ∈ ℝ^n\nx ∈ ℝ^n\nb ∈ ℤ^3\nM ∈ ℝ^(4×4)",
    [vector(q6), vector(p6), rust("SVector::<i64, 3>::new(3, 5, 1)"), fixed_matrix(S4)],
    y=(np.diff(q6) ** 2).sum() + q6[5] * q6[0],
    z=p6[4] + S4[2, 1] + p6[4],
)
case(
    "integers_and_reals_in_sets",
    "S = {1, 2, 3} ∪ {k² for k ∈ T if k > 1}\ny = ∑_(k ∈ S \\ {1}) k\nz = |S|\nR = {0.5} ∩ T\nwhere\nT ∈ {ℤ}",
    [integer_set([-4, 2, 5])],
    S=[1, 2, 3, 4, 25],
    y=34,
    z=5,
    R=[],
)
case(
    "sparse_stays_sparse",
    "C = A²\nD = A ∘ B\nE = A + B\nF = A ∘ G\nH = A³ - 2B\ny = A² b\ns = trace(A ∘ B) + |A|\ntrace from linearalgebra\nwhere\nA ∈ ℝ^(n×n) sparse\nB ∈ ℝ^(n×n) sparse\nG ∈ ℝ^(n×n)\nb ∈ ℝ^n",
    [sparse(Ssparse), sparse(Tsparse), matrix(S5), vector(n5)],
    C=Ssparse @ Ssparse,
    D=Ssparse * Tsparse,
    E=Ssparse + Tsparse,
    F=Ssparse * S5,
    H=Ssparse @ Ssparse @ Ssparse - 2 * Tsparse,
    y=Ssparse @ Ssparse @ n5,
    s=np.trace(Ssparse * Tsparse) + np.linalg.det(Ssparse),
)
case(
    "sparse_solves",
    "y = A \\ b + A⁻¹ b\nX = A⁻¹ G\nz = bᵀ A⁻¹ b\nwhere\nA ∈ ℝ^(n×n) sparse\nb ∈ ℝ^n\nG ∈ ℝ^(n×n)",
    [sparse(Ssparse), vector(n5), matrix(S5)],
    y=2 * np.linalg.solve(Ssparse, n5),
    X=np.linalg.solve(Ssparse, S5),
    z=n5 @ np.linalg.solve(Ssparse, n5),
)
case(
    "norms_with_powers",
    "y = ||x||_p + ||x||_3^2 + ‖x‖_∞ + ||A||_F² + ||x||_P^2 + ‖x‖₁\nwhere\nx ∈ ℝ^n\np ∈ ℝ\nA ∈ ℝ^(n×m)\nP ∈ ℝ^(n×n)",
    [vector(n5), real(1.5), matrix(M45.T), matrix(S5)],
    y=(np.abs(n5) ** 1.5).sum() ** (1 / 1.5)
    + np.linalg.norm(n5, 3) ** 2
    + np.abs(n5).max()
    + (M45**2).sum()
    + n5 @ S5 @ n5
    + np.abs(n5).sum(),
)
case(
    "callbacks_of_sequences",
    "y = ∑_i f(x_i, a)\nz_i = f(x_i, i)\nwhere\nf ∈ ℝ^3, ℝ → ℝ\nx_i ∈ ℝ^3\na ∈ ℝ",
    [rust("|u: DVec3, t: f64| u.x * t + u.z"), fix(seq4), real(a)],
    y=sum(x[0] * a + x[2] for x in seq4),
    z=[x[0] * (i + 1) + x[2] for i, x in enumerate(seq4)],
)
case(
    "function_of_two_subscripts_and_a_vector",
    "K_ij(x) = x_i x_j where i, j ∈ ℤ, x ∈ ℝ^n\ny = K_1,2(u) + K(1, 3, u) + K_2(3, u)\nwhere\nu ∈ ℝ^4",
    [fixed_vector(q6[:4])],
    y=q6[0] * q6[1] + q6[0] * q6[2] + q6[1] * q6[2],
)
case(
    "products_over_indices",
    "y = (∏_(i=1)^n (x - a_i)) / ∏_i b_i\nz = ∏_(i for i ≠ 2) a_i\nwhere\na ∈ ℝ^n\nb ∈ ℝ^n\nx ∈ ℝ",
    [vector(q6), vector(p6), real(0.3)],
    y=np.prod(0.3 - q6) / np.prod(p6),
    z=np.prod(np.delete(q6, 1)),
)
case(
    "least_of_everything",
    "y = min(a, b, 3) + max({a, b}) - min(x) + max(A)\nwhere\na, b ∈ ℝ\nx ∈ ℝ^n\nA ∈ ℝ^(n×n)",
    [real(a), real(b), vector(q6), matrix(M66)],
    y=min(a, b, 3) + max(a, b) - q6.min() + M66.max(),
)
case(
    "halves_of_integers",
    "y = n/2 + 1/2\nk = n - 1\nz = ∑_(i = 1)^k i/n\nwhere\nn ∈ ℤ",
    [integer(7)],
    y=4,
    k=6,
    z=21 / 7,
)
case(
    "sequences_as_vectors",
    "y = A w\nz = A \\ w\nt = b⋅w + (A w)⋅b\nd = b - w\nwhere\nA ∈ ℝ^(n×n)\nw_i ∈ ℝ\nb ∈ ℝ^n",
    [matrix(S5), reals(q6[:5]), vector(n5)],
    y=S5 @ q6[:5],
    z=np.linalg.solve(S5, q6[:5]),
    t=n5 @ q6[:5] + S5 @ q6[:5] @ n5,
    d=n5 - q6[:5],
)
case(
    "pairs_of_a_set",
    "y = ∑_((i,j) ∈ P) a_i b_j\nz = ∑_(p ∈ P) a_(p_1) b_(p_2)\nQ = {tuple(j, i) for i, j ∈ P if i < j}\nc = |Q|\nwhere\nP ∈ {ℤ×ℤ}\na ∈ ℝ^n\nb ∈ ℝ^m",
    [pairs([(1, 2), (3, 1), (2, 5)]), vector(q6), vector(n5)],
    y=q6[0] * n5[1] + q6[2] * n5[0] + q6[1] * n5[4],
    z=q6[0] * n5[1] + q6[2] * n5[0] + q6[1] * n5[4],
    c=2,
)
case(
    "degrees_and_laplacian",
    "A ∈ ℝ^(n×n)\nA_ij = { 1 if (i,j) ∈ P\n         0 otherwise\nd_i = ∑_j A_ij\nD_ii = d_i\nL = D - A\nq = xᵀ L x\nwhere\nP ∈ {ℤ×ℤ} index\nx ∈ ℝ^n",
    [pairs([(0, 1), (1, 0), (1, 2), (2, 1), (0, 3), (3, 0)]), vector(q6[:4])],
    d=[2, 2, 1, 1],
    L=np.array([[2, -1, 0, -1], [-1, 2, -1, 0], [0, -1, 1, 0], [-1, 0, 0, 1]]),
    q=(q6[0] - q6[1]) ** 2 + (q6[1] - q6[2]) ** 2 + (q6[0] - q6[3]) ** 2,
)
case(
    "projection_out_of",
    "v = (I_n - u uᵀ/(u⋅u)) w\nc = <u, v> + ⟨v, v⟩_P\nwhere\nu, w ∈ ℝ^n\nP ∈ ℝ^(n×n)",
    [vector(n5), vector(m5), matrix(S5)],
    v=m5 - n5 * (n5 @ m5) / (n5 @ n5),
    c=(lambda v: n5 @ v + v @ S5 @ v)(m5 - n5 * (n5 @ m5) / (n5 @ n5)),
)
case(
    "columns_by_assignment",
    "A ∈ ℝ^(3×2)\nA_*,1 = u\nA_*,2 = v\nG = AᵀA\nwhere\nu, v ∈ ℝ^3",
    [fixed_vector(u3), fixed_vector(v3)],
    A=np.column_stack([u3, v3]),
    G=np.column_stack([u3, v3]).T @ np.column_stack([u3, v3]),
)
case(
    "locals_of_locals",
    "f(x) = g(x) + 1 where x ∈ ℝ\ng(x) = h x where x ∈ ℝ,\n  h = 2 k,\n  k = x + s\ns = ∑_i w_i\ny = f(3)\nwhere\nw_i ∈ ℝ",
    [reals(q6)],
    y=2 * (3 + q6.sum()) * 3 + 1,
)
case(
    "moving_average",
    "y ∈ ℝ^n\ny_i = 1/(2k+1) ∑_(j = -k)^k a_(max(1, min(n, i + j)))\nwhere\na ∈ ℝ^n\nk ∈ ℤ\nb ∈ ℝ^n",
    [vector(q6), integer(1), vector(p6)],
    y=[(q6[max(0, i - 1)] + q6[i] + q6[min(5, i + 1)]) / 3 for i in range(6)],
)
case(
    "blocks_with_multiples_of_identities",
    """C = [A -I
     -2aI Aᵀ]
D = [A (a I); I 0]
E = [I -I]
F = [B -I; -aI 0]
where
A ∈ ℝ^(2×2)
a ∈ ℝ
B ∈ ℝ^(n×n) sparse""",
    [fixed_matrix(A2), real(a), sparse(S5)],
    C=np.block([[A2, -np.eye(2)], [-2 * a * np.eye(2), A2.T]]),
    D=np.block([[A2, a * np.eye(2)], [np.eye(2), Z2]]),
    E=[1, -1],
    F=np.block([[S5, -np.eye(5)], [-a * np.eye(5), np.zeros((5, 5))]]),
)
