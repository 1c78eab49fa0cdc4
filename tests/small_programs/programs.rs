programs! {
AddScalars, PlainAddScalars = r##"c = a + b
where
a ∈ ℝ
b ∈ ℝ"##;

AddMatrices, PlainAddMatrices = r##"A = B + C
where
B: matrix(3,2)
C: matrix(3,2)"##;

SideBySide, PlainSideBySide = r##"B = [ A C ]
where
A: ℝ^(3×3) : a
C: ℝ^(3×3) : a"##;

OnTop, PlainOnTop = r##"B = [ A ; C ]
where
A: ℝ^(2×2): a matrix
C: ℝ^(2×2)"##;

BlockZero, PlainBlockZero = r##"B = [ A  0
      0  C ]
where
A: ℝ^(2 × 2)
C: ℝ^(2 × 2)"##;

BlockAffine, PlainBlockAffine = r##"B = [ A a
      0 1 ]
where
A ∈ ℝ^(3×3)
a ∈ ℝ^3"##;

BlockOnes, PlainBlockOnes = r##"C = [ 1_n,m A; I 0 ]
where
A ∈ ℝ^(n×m)"##;

BlockRowOne, PlainBlockRowOne = r##"y = [A I_3
     0 1]
where
A ∈ ℝ^(3×2)"##;

BlockColumn, PlainBlockColumn = r##"C = [A u
     uᵀ 1]
where
A ∈ ℝ^(3×3)
u ∈ ℝ^3"##;

Row, PlainRow = r##"A = [a b c]
where
a ∈ ℝ
b ∈ ℝ
c ∈ ℝ"##;

SumOfSequence, PlainSumOfSequence = r##"b = ∑_i w_i
where
w_i ∈ ℝ: weights"##;

SumFiltered, PlainSumFiltered = r##"b = sum_(i for i > 1) w_i
where
w ∈ ℝ^n"##;

SumFilteredTwice, PlainSumFilteredTwice = r##"b = ∑_(i for i > 1 and i ≤ 3) w_i
where
w ∈ ℝ^5"##;

SumNested, PlainSumNested = r##"b = ∑_i ∑_j A_i,j
where
A ∈ ℝ^(m×n)"##;

SumOffDiagonal, PlainSumOffDiagonal = r##"b = ∑_i ∑_(j for j ≠ i) A_ij
where
A ∈ ℝ^(n×n)"##;

SumOuter, PlainSumOuter = r##"A = ∑_i w_i x_i x_iᵀ
where
w_i ∈ ℝ
x_i ∈ ℝ^3"##;

Covariance, PlainCovariance = r##"`x̄` = 1/n ∑_i x_i
C = 1/n ∑_i (x_i - `x̄`)(x_i - `x̄`)ᵀ
where
x_i ∈ ℝ^3
n ∈ ℤ"##;

Entries, PlainEntries = r##"a_i = b_i c_i
where
b ∈ ℝ^n
c ∈ ℝ^n"##;

EntriesOfMatrix, PlainEntriesOfMatrix = r##"C_ij = A_ij B_ij + 1
where
A ∈ ℝ^(m×n)
B ∈ ℝ^(m×n)"##;

TransposedEntries, PlainTransposedEntries = r##"C_ij = A_ji
where
A ∈ ℝ^(m×n)"##;

MatrixProductByEntries, PlainMatrixProductByEntries = r##"C_ij = ∑_k A_ik B_kj
where
A ∈ ℝ^(m×n)
B ∈ ℝ^(n×m)"##;

Hadamard, PlainHadamard = r##"C = A∘B
where
A ∈ ℝ^(m×n)
B ∈ ℝ^(m×n)"##;

Kronecker, PlainKronecker = r##"C = A⊗B
where
A ∈ ℝ^(m×n)
B ∈ ℝ^(p×q)"##;

KroneckerVectors, PlainKroneckerVectors = r##"C = u⊗v
where
u ∈ ℝ^3
v ∈ ℝ^n"##;

Frobenius, PlainFrobenius = r##"c = A:B
where
A ∈ ℝ^(m×n)
B ∈ ℝ^(m×n)"##;

Cross, PlainCross = r##"c = a × b
where
a ∈ ℝ^3
b ∈ ℝ^3"##;

Dot, PlainDot = r##"c = a⋅b + a·b + aᵀb
where
a ∈ ℝ^n
b ∈ ℝ^n"##;

Inner, PlainInner = r##"c = <a,b> + ⟨a,b⟩_M
where
a ∈ ℝ^n
b ∈ ℝ^n
M ∈ ℝ^(n×n)"##;

Solve, PlainSolve = r##"c = A \ b
d = A⁻¹ b
f = A^(-1) b
g = A^-1 b
where
A ∈ ℝ^(n×n)
b ∈ ℝ^n"##;

SolveMatrix, PlainSolveMatrix = r##"C = A⁻¹ B
D = A⁻¹ A⁻¹ B
where
A ∈ ℝ^(3×3)
B ∈ ℝ^(3×2)"##;

Inverse, PlainInverse = r##"B = (A + 2I_3)^(-1) + C
where
A ∈ ℝ^(3×3)
C ∈ ℝ^(3×3)"##;

MatrixPower, PlainMatrixPower = r##"B = A^2 A^3
C = A²
where
A ∈ ℝ^(n×n)"##;

MatrixRoot, PlainMatrixRoot = r##"B = A^(-1/2)
C = A^(1/2)
where
A ∈ ℝ^(n×n)"##;

ScalarPower, PlainScalarPower = r##"c = a^(b+1) + a^b
d = a^-b
where
a ∈ ℝ
b ∈ ℝ"##;

Determinant, PlainDeterminant = r##"d = |A|
e = |B|
where
A ∈ ℝ^(3×3)
B ∈ ℝ^(n×n)"##;

VectorNorms, PlainVectorNorms = r##"c = ‖a‖ + ‖a‖_2
d = ‖a‖_1
f = ‖a‖_∞
g = ||a||_3
h = ‖a‖²
k = ||a||_2^2 + ||a||^2_2 + ||a||₂²
z = ||a||_0
where
a ∈ ℝ^n"##;

MatrixNorms, PlainMatrixNorms = r##"c = ‖A‖
d = ‖A‖_F
f = ‖A‖_*
where
A ∈ ℝ^(n×m)"##;

WeightedNorm, PlainWeightedNorm = r##"c = ‖a‖_P
d = ‖a‖_P^2
f = ‖a‖_p
where
a ∈ ℝ^n
P ∈ ℝ^(n×n)
p ∈ ℝ"##;

Absolute, PlainAbsolute = r##"c = |a| + |b|
where
a,b ∈ ℝ"##;

Callback, PlainCallback = r##"b = f(a)
where
f ∈ ℝ → ℝ
a ∈ ℝ"##;

CallbackVectors, PlainCallbackVectors = r##"b = f(a, c)
where
f ∈ ℝ,ℝ^n → ℝ^n
a ∈ ℝ
c ∈ ℝ^n"##;

CallbackMatrix, PlainCallbackMatrix = r##"b = f(P)
where
f ∈ ℝ^(n×m) → ℝ^(m×n)
P ∈ ℝ^(n×m)"##;

CallbackNothing, PlainCallbackNothing = r##"y = f() + g()
where
f ∈ {} → ℝ
g ∈ ∅ -> ℝ"##;

CallbackEach, PlainCallbackEach = r##"y_i = f(x_i)
where
f ∈ ℝ^3 → ℝ
x_i ∈ ℝ^3"##;

Callbacks, PlainCallbacks = r##"b = ∑_i f_i(q) w_i
where
f_i ∈ ℝ^3 → ℝ
q ∈ ℝ^3
w_i ∈ ℝ"##;

CallbackTwoResults, PlainCallbackTwoResults = r##"b, c = f(a)
where
f ∈ ℝ → ℝ, ℝ
a ∈ ℝ"##;

Cases, PlainCases = r##"y = { 1 if x > 0
      0 otherwise
where
x ∈ ℝ"##;

CasesAnd, PlainCasesAnd = r##"y = { a if x > 0 and a < 2
      b if x == 0 or b != 3
      0 otherwise
where
x, a, b ∈ ℝ"##;

CasesSet, PlainCasesSet = r##"y = { a if k ∈ S
      2a if k ∉ S
      0 otherwise
where
a ∈ ℝ
k ∈ ℤ
S ∈ {ℤ}"##;

CasesEntries, PlainCasesEntries = r##"y_i = { x_i if x_i > 0
      0 otherwise
where
x ∈ ℝ^n"##;

CasesMatrix, PlainCasesMatrix = r##"A_ij = { 1 if i = j
         B_ij otherwise
where
B ∈ ℝ^(n×n)"##;

LocalFunction, PlainLocalFunction = r##"f(x) = x^2 + 1 where x ∈ ℝ
y = f(a) + f(2)
a ∈ ℝ"##;

LocalFunctionTwo, PlainLocalFunctionTwo = r##"f(x,y) = x y where x, y ∈ ℝ
z = f(a, 3)
a ∈ ℝ"##;

LocalFunctionAffine, PlainLocalFunctionAffine = r##"f(x) = Ax + b where x ∈ ℝ^n
y = f(c)
A ∈ ℝ^(n×n)
b ∈ ℝ^n
c ∈ ℝ^n"##;

LocalFunctionAnySize, PlainLocalFunctionAnySize = r##"g(u, v) = uᵀv where u ∈ ℝ^k, v ∈ ℝ^k
y = g(a,b)
z = g(c,c)
a,b ∈ ℝ^n
c ∈ ℝ^3"##;

Sphere, PlainSphere = r##"sin, cos from trigonometry
`x(θ, ϕ)` = [Rcos(θ)cos(ϕ)
             Rsin(θ)cos(ϕ)
             Rsin(ϕ)]
where
ϕ ∈ ℝ : angle between 0 and 2π
θ ∈ ℝ : angle between -π/2 and π/2
R ∈ ℝ : the radius of the sphere"##;

ClosestPoint, PlainClosestPoint = r##"given
p_i ∈ ℝ^3: points on lines
d_i ∈ ℝ^3: unit directions along lines
P_i = ( I_3 - d_i d_iᵀ )
q = ( ∑_i P_i )⁻¹ ( ∑_i P_i p_i )"##;

Kernel, PlainKernel = r##"Ω = [`e₁` `e₂`][`k₁`   0
                 0    `k₂`] [`e₁`ᵀ
                             `e₂`ᵀ]
where
`k₁` ∈ ℝ  : control
`k₂` ∈ ℝ  : control
`e₁` ∈ ℝ^2: orthogonal direction vectors
`e₂` ∈ ℝ^2: orthogonal direction vectors"##;

MutualInformation, PlainMutualInformation = r##"`I(X;Y)` = ∑_i ∑_j x_j p_i,j log_2(p_i,j/∑_k x_k p_i,k)
where
x ∈ ℝ^n
p ∈ ℝ^(m×n)"##;

Demosaic, PlainDemosaic = r##"`C(x,y)` = (∑_n ∑_i c_n,i w_n,i `R̂`_n) / (∑_n ∑_i w_n,i `R̂`_n)
where
c ∈ ℝ^(f×s): the value of the Bayer pixel
w ∈ ℝ^(f×s): the local sample weight
`R̂` ∈ ℝ^f: the local robustness"##;

Divergence, PlainDivergence = r##"`D_{KL}` = 1/2 (tr(`Σ₂`⁻¹`Σ₁`) - n + ln(|`Σ₂`|/|`Σ₁`|))
tr from linearalgebra
where
`Σ₁`, `Σ₂` ∈ ℝ^(n×n)"##;

BlockProduct, PlainBlockProduct = r##"[ P₁  0
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
`Ũ` ∈ ℝ^(n×n)"##;

VertexNormal, PlainVertexNormal = r##"`n(v)` = ( ∑_(i for i ∈ `N₁(v)`) α_i n(T_i) )/‖ ∑_(i for i ∈ `N₁(v)`) α_i n(T_i) ‖
where
T_i ∈ ℝ^3
α_i ∈ ℝ
`N₁(v)` ∈ {ℤ}
n ∈ ℝ^3 → ℝ^3"##;

QuasiMonteCarlo, PlainQuasiMonteCarlo = r##"∑_i α_i + 1/M ∑_i ∑_j (f(X_i,j)/`p_c`(X_i,j) - (∑_k α_k p_k(X_i,j))/`p_c`(X_i,j))
where
α ∈ ℝ^N
p_j ∈ ℝ → ℝ
X ∈ ℝ^(N×m)
M ∈ ℝ
f ∈ ℝ → ℝ
`p_c` ∈ ℝ → ℝ"##;

ViewPlane, PlainViewPlane = r##"r̄ = v̄×ō
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
δ ∈ ℝ,ℝ → ℝ"##;

Conformal, PlainConformal = r##"`E_{LSCM}` = ∑_T A_T ‖ M_T v_T - [0 -1
                                   1  0] M_T u_T ‖²
where
v_i ∈ ℝ^3
u_i ∈ ℝ^3
M_i ∈ ℝ^(2×3)
A_i ∈ ℝ"##;

Diagonal, PlainDiagonal = r##"D_ii = w_i
y = D w
where
w ∈ ℝ^n"##;

Slices, PlainSlices = r##"b = A_1,*
c = A_*,2
d = A_2,3
where
A ∈ ℝ^(m×n)"##;

NestedIndex, PlainNestedIndex = r##"b = ∑_i x_(k_i)
where
x ∈ ℝ^n
k_i ∈ ℤ"##;

Trigonometric, PlainTrigonometric = r##"sin, cos, tan, asin, acos, atan, arcsin, arccos, arctan, sinh, cosh, tanh, asinh, acosh, atanh, arsinh, arcosh, artanh, cot, sec, csc, atan2 from trigonometry
b = sin(a) + cos(a) + tan(a) + asin(a) + acos(a) + atan(a)
c = arcsin(a) + arccos(a) + arctan(a) + sinh(a) + cosh(a)+tanh(a)
d = asinh(a) + acosh(1+a) + atanh(a) + arsinh(a)+arcosh(1 + a)+artanh(a)
f = cot(a)+sec(a)+csc(a)+atan2(a, -2a)
where
a ∈ ℝ"##;

TrigonometricEntries, PlainTrigonometricEntries = r##"sin from trigonometry
b = sin(A)
c = sin²(a) + sin^2(a)
where
A ∈ ℝ^(m×n)
a ∈ ℝ"##;

Exponentials, PlainExponentials = r##"e from trigonometry
b = e^2 + log(a) + ln(a) + log_2(a) + log_10(a) + log₂(a) + exp(a) + √a + sqrt(a)
where
a ∈ ℝ"##;

LinearAlgebraFunctions, PlainLinearAlgebraFunctions = r##"trace, tr, diag, vec, det, rank, inv from linearalgebra
a = trace(A)
b = tr(A)
c = diag(A)
d = vec(A)
f = det(A)
g = rank(A)
h = inv(A)
where
A ∈ ℝ^(n×n)"##;

DiagonalOfVector, PlainDiagonalOfVector = r##"diag from linearalgebra
D = diag(x)
where
x ∈ ℝ^n"##;

Chain, PlainChain = r##"a = b + 1
c = a b
d = a c
where
b ∈ ℝ"##;

Bare, PlainBare = r##"a + b
where
a, b ∈ ℝ"##;

Greek, PlainGreek = r##"θ = α β + γ
where
α, β, γ ∈ ℝ"##;

Integers, PlainIntegers = r##"c = a b + 2
d = a/b
where
a, b ∈ ℤ"##;

IntegerVectors, PlainIntegerVectors = r##"c = a + b
where
a, b ∈ ℤ^n"##;

IntegerMatrices, PlainIntegerMatrices = r##"C = A B
where
A ∈ ℤ^(2×3)
B ∈ ℤ^(3×2)"##;

SequenceDefinition, PlainSequenceDefinition = r##"y_i = A x_i
where
A ∈ ℝ^(3×3)
x_i ∈ ℝ^3"##;

SequenceOfMatrices, PlainSequenceOfMatrices = r##"B_i = A_i A_iᵀ
where
A_i ∈ ℝ^(2×3)"##;

SizeOf, PlainSizeOf = r##"n = #x
m, k = #A
where
x ∈ ℝ^3
A ∈ ℝ^(2×4)"##;

SetSum, PlainSetSum = r##"b = ∑_(i ∈ S) i
c = |S|
where
S ∈ {ℤ}"##;

PairSum, PlainPairSum = r##"b = ∑_((i,j) ∈ S) i j
where
S ∈ {ℤ×ℤ}"##;

PairEntries, PlainPairEntries = r##"b = ∑_(i,j ∈ S) A_i,j
where
S ∈ {ℤ×ℤ}
A ∈ ℝ^(n×n)"##;

SetFilter, PlainSetFilter = r##"b = ∑_(i for i ∈ S) x_i
where
S ∈ {ℤ}
x ∈ ℝ^n"##;

PairFilter, PlainPairFilter = r##"b = ∑_i ∑_(j for (i,j) ∈ S) A_ij
where
S ∈ {ℤ×ℤ}
A ∈ ℝ^(n×n)"##;

Ones, PlainOnes = r##"y = 1_3ᵀ x
z = 𝟙_n
k = 0_n,m
where
x ∈ ℝ^3
n, m ∈ ℤ"##;

VectorLiteral, PlainVectorLiteral = r##"y = (a, 2, b)
z = (u, a)
where
a, b ∈ ℝ
u ∈ ℝ^3"##;

Precedence, PlainPrecedence = r##"y = 2a^2b/c - a/b c
z = -a^2 + 1/2a
where
a,b,c ∈ ℝ"##;

Ascii, PlainAscii = r##"y = sum_(i = 1)^n x_i^2 + `norm`
`norm` = ||x||
where
x \in RR^n"##;

Integral, PlainIntegral = r##"y = int_[0, 1] t^2 𝕕t"##;

IntegralBounds, PlainIntegralBounds = r##"y = ∫_0^1 a t^2 𝕕t
where
a ∈ ℝ"##;

MeanNormalCurvature, PlainMeanNormalCurvature = r##"`H(p)` = 1/(2π)int_[0, 2π] `kₙ`(φ, p) 𝕕φ
where
p ∈ ℝ^3 : point on the surface
`kₙ` ∈ ℝ,ℝ^3 → ℝ : normal curvature"##;

Argmin, PlainArgmin = r##"y = argmin_(x ∈ ℝ) (x - a)^2
where
a ∈ ℝ"##;

Rigid, PlainRigid = r##"min_(C ∈ ℝ^3) ∑_i ‖x_i + (R_i - I_3)C‖²
where
x_i ∈ ℝ^3
R_i ∈ ℝ^(3×3)"##;

RigidArgument, PlainRigidArgument = r##"C = argmin_(C ∈ ℝ^3) ∑_i ‖x_i + (R_i - I_3)C‖²
where
x_i ∈ ℝ^3
R_i ∈ ℝ^(3×3)"##;

LeastSquares, PlainLeastSquares = r##"`x̂` = argmin_(x ∈ ℝ^n) ‖A x - b‖² 
where
A ∈ ℝ^(m×n)
b ∈ ℝ^m"##;

Laplacian, PlainLaplacian = r##"L_i,j = { w_i,j if (i,j) ∈ E
          0 otherwise
L_i,i = -∑_(l for l ≠ i) L_i,l
where
w ∈ ℝ^(n×n): edge weight matrix
E ∈ {ℤ×ℤ} index: edges
n ∈ ℤ
L ∈ ℝ^(n×n)"##;

SparsePairs, PlainSparsePairs = r##"P ∈ {ℤ×ℤ} : index pairs
n ∈ ℤ
K ∈ ℝ^(n×n)
d_i ∈ ℝ
K_ij = { d_i + d_j if (i,j) ∈ P
         0 otherwise
K_ii = -∑_(j for j != i) K_ij"##;

SparseOnes, PlainSparseOnes = r##"A_ij = { 1 if (i,j) ∈ P
         0 otherwise
where
P ∈ {ℤ×ℤ}
A ∈ ℝ^(4×4)"##;

Ragged, PlainRagged = r##"b = ∑_i ‖x_i‖
where
x_i ∈ ℝ^(n_i)"##;

ExpressionSizes, PlainExpressionSizes = r##"y = A b
where
A ∈ ℝ^((n+1)×n)
b ∈ ℝ^n"##;

Tuples, PlainTuples = r##"u, v = tuple(a, b)
where
a, b ∈ ℝ"##;

SequenceSubscripts, PlainSequenceSubscripts = r##"y = x_1 + x_2
z = A_1,2
w = B_1
v = B_2,2,1
where
x ∈ ℝ^3
A ∈ ℝ^(2×2)
B_i ∈ ℝ^(2×2)"##;

SumEntriesOfMatrices, PlainSumEntriesOfMatrices = r##"s = ∑_i B_i,1,2
where
B_i ∈ ℝ^(2×2)"##;

QuotientOfSums, PlainQuotientOfSums = r##"y = ∑_i x_i / ∑_i w_i
where
x, w ∈ ℝ^n"##;

QuadraticForm, PlainQuadraticForm = r##"y = uᵀ A v
B = u vᵀ
where
u, v ∈ ℝ^n
A ∈ ℝ^(n×n)"##;

PseudoInverse, PlainPseudoInverse = r##"y = A⁺ b
P = A⁺
where
A ∈ ℝ^(m×n)
b ∈ ℝ^m"##;

SparseAlgebra, PlainSparseAlgebra = r##"y = A x
B = A Aᵀ
C = A + 2A - A∘A
D = [A 0; 0 A]
z = A \ x
where
A ∈ ℝ^(n×n) sparse
x ∈ ℝ^n"##;

Words, PlainWords = r##"y = scalar1 + v_1
where
scalar1: scalar
v: vector(n)"##;

LeastAndGreatest, PlainLeastAndGreatest = r##"y = min(a, b) + max(a,b,3)
z = min(S) + max(x)
where
a,b ∈ ℝ
S ∈ {ℝ}
x ∈ ℝ^n"##;

SetLiteral, PlainSetLiteral = r##"S = {1, 2, a}
y = |S|
where
a ∈ ℤ"##;

Fractions, PlainFractions = r##"y = ½a + ¾ + 2/3 a
where
a ∈ ℝ"##;

Bars, PlainBars = r##"y = |a|b|c| + ||u||||v|| + |a||b|
where
a,b,c ∈ ℝ
u, v ∈ ℝ^3"##;

MixedProgram, PlainMixedProgram = r##"a, b ∈ ℝ^n
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
Q = (S ∪ odd) \ S"##;

SingleEntries, PlainSingleEntries = r##"y_1 = a
y_2 = b
y ∈ ℝ^3
where
a,b ∈ ℝ"##;

AddTo, PlainAddTo = r##"y_i = x_i
y_i += 2x_i
where
x ∈ ℝ^n"##;

EntriesOfRow, PlainEntriesOfRow = r##"P_i,* = x_i
where
x_i ∈ ℝ^3"##;

EntriesOfColumn, PlainEntriesOfColumn = r##"P_*,i = x_i
where
x_i ∈ ℝ^3"##;

TripleSum, PlainTripleSum = r##"y = ∑_i ∑_j ∑_k A_ij B_jk C_ki
where
A,B,C ∈ ℝ^(3×3)"##;

Constrained, PlainConstrained = r##"y = min_(x ∈ ℝ^2) ‖x‖² s.t. x_1 ≥ 1"##;

Simplex, PlainSimplex = r##"y = argmin_(x ∈ ℝ^n) xᵀ A x + bᵀ x
s.t.
x ≥ 0
∑_i x_i = 1
where
A ∈ ℝ^(n×n)
b ∈ ℝ^n"##;

UnitVectors, PlainUnitVectors = r##"n(u) = u/‖u‖ where u ∈ ℝ^3
y = n(a) × n(b)
a, b ∈ ℝ^3"##;

ProductOfSequence, PlainProductOfSequence = r##"y = ∏_i w_i
z = ∏_(i = 1)^4 i
where
w ∈ ℝ^n"##;

Factorial, PlainFactorial = r##"g(k) = { 1 if k < 1
         k g(k-1) otherwise
where k ∈ ℤ
y = g(5)"##;

Overloads, PlainOverloads = r##"f(x) = x² where x ∈ ℝ
f(x) = ‖x‖ where x ∈ ℝ^3
y = f(a) + f(u)
a ∈ ℝ
u ∈ ℝ^3"##;

Ranges, PlainRanges = r##"y = ∑_(k=1)^n ∑_(j=k)^n A_k,j
where
A ∈ ℝ^(n×n)"##;

SumWhere, PlainSumWhere = r##"y = ∑_i s where s = x_i² + 1
where
x ∈ ℝ^n"##;

Ternary, PlainTernary = r##"y = { a if a > b and b > 0 or c = 2.25
  b otherwise
where
a,b,c ∈ ℝ"##;

VectorOfVectors, PlainVectorOfVectors = r##"y = (u, 2v, 1)
where
u,v ∈ ℝ^3"##;

TraceProduct, PlainTraceProduct = r##"y = tr(A^T A)
tr from linearalgebra
where
A ∈ ℝ^(m×n)"##;

ScalarMatrix, PlainScalarMatrix = r##"y = 2A/3 - A a
where
A ∈ ℝ^(m×n)
a ∈ ℝ"##;

SumOfSetValues, PlainSumOfSetValues = r##"y = ∑_(x ∈ S) x²
where
S ∈ {ℝ}"##;

SetOperations, PlainSetOperations = r##"A = S ∪ W
B = S ∩ W
C = S \ W
D = S - W
where
S,W ∈ {ℤ}"##;

FunctionOfSequence, PlainFunctionOfSequence = r##"L(q) = ∑_i ‖q_i‖ where q_i ∈ ℝ^3
y = L(x)
x_i ∈ ℝ^3"##;

GivenBlock, PlainGivenBlock = r##"given
A ∈ ℝ^(2×2)
b ∈ ℝ^2
y = A b
given
c ∈ ℝ
z = c y"##;

DoubleSumWeights, PlainDoubleSumWeights = r##"y = ∑_i ∑_j w_ij ‖x_i - x_j‖²
where
w ∈ ℝ^(n×n)
x_i ∈ ℝ^3"##;

InfinityPiece, PlainInfinityPiece = r##"y = { ∞ if a > 10
 ln(a) otherwise
where
a ∈ ℝ"##;

IndexSetAttribute, PlainIndexSetAttribute = r##"y = ∑_(i ∈ S) x_i
where
S ∈ {ℤ} index
x ∈ ℝ^n"##;

IndexParameter, PlainIndexParameter = r##"y = x_k
where
k ∈ ℤ index
x ∈ ℝ^n"##;

IntegerParameter, PlainIntegerParameter = r##"y = x_k
where
k ∈ ℤ
x ∈ ℝ^n"##;

NamedSize, PlainNamedSize = r##"y = ∑_(i=1)^n x_i i
z = n
where
x ∈ ℝ^n"##;

RowVectorTimes, PlainRowVectorTimes = r##"y = [1 2 3] u
z = [1;2;3]
w = [1;2;3]ᵀ u
where
u ∈ ℝ^3"##;

ColumnPlusVector, PlainColumnPlusVector = r##"y = [1;2;3] + u
where
u ∈ ℝ^3"##;

MultilineMatrix, PlainMultilineMatrix = r##"A = [a b
     b c
    ]
where
a,b,c ∈ ℝ"##;

NegativeCells, PlainNegativeCells = r##"A = [a -b; -b a]
B = [a - b]
C = [a-b a]
where
a,b ∈ ℝ"##;

BarsInRows, PlainBarsInRows = r##"A = [|a| ||u||; 1 2]
where
a ∈ ℝ
u ∈ ℝ^3"##;

TransposeSpellings, PlainTransposeSpellings = r##"A = B^T
C = Bᵀ
where
B ∈ ℝ^(2×3)"##;

SubscriptDigits, PlainSubscriptDigits = r##"y = x₁ + A₁,₂
where
x ∈ ℝ^3
A ∈ ℝ^(2×2)"##;

IndexTwelve, PlainIndexTwelve = r##"y = w_12
where
w ∈ ℝ^13"##;

Combining, PlainCombining = r##"y = x̂ + n̄
where
x̂, n̄ ∈ ℝ"##;

Splitting, PlainSplitting = r##"y = abc + cab
where
ab, c ∈ ℝ"##;

LettersProduct, PlainLettersProduct = r##"y = ab
where
a, b ∈ ℝ"##;

KeywordsAsProducts, PlainKeywordsAsProducts = r##"y = a s + i f
where
a,s,i,f ∈ ℝ"##;

DivisionSpellings, PlainDivisionSpellings = r##"y = a÷b + a/b
where
a,b ∈ ℝ"##;

ExponentNumbers, PlainExponentNumbers = r##"y = 2E3 + 1.5E-2 + .5 + 3.
z = 2E
E = 3"##;

Inequalities, PlainInequalities = r##"y = { 1 if a <= b
 2 if a >= 10
 3 if a ⩾ b and a ⩽ 2
 4 otherwise
where
a,b ∈ ℝ"##;

ColonCases, PlainColonCases = r##"y = { 1 if k ∈ S
 2 otherwise
where
k ∈ ℤ
S ∈ {ℤ}"##;

PairCondition, PlainPairCondition = r##"y = { 1 if (i, j) ∈ P
 2 otherwise
where
i, j ∈ ℤ
P ∈ {ℤ×ℤ}"##;

Nuclear, PlainNuclear = r##"y = ‖A‖_*
where
A ∈ ℝ^(3×3)"##;

NormOfDifference, PlainNormOfDifference = r##"y = ‖x_1 - x_2‖
where
x_i ∈ ℝ^3"##;

InnerBracketFunctions, PlainInnerBracketFunctions = r##"y = <f(a), u>
where
f ∈ ℝ → ℝ^3
a ∈ ℝ
u ∈ ℝ^3"##;

FunctionPower, PlainFunctionPower = r##"y = f(a)^2
z = f(a)(b)
where
f ∈ ℝ → ℝ
a,b ∈ ℝ"##;

SubscriptFunction, PlainSubscriptFunction = r##"g_k(x) = k x where k ∈ ℤ, x ∈ ℝ
y = g_2(a) + g(3, a)
a ∈ ℝ"##;

FunctionsWithSubscriptsOnly, PlainFunctionsWithSubscriptsOnly = r##"h_i,j = i + 2j where i, j ∈ ℤ
y = h_1,2 + h(3,4)"##;

Locals, PlainLocals = r##"f(x) = s + t where x ∈ ℝ, s = x², t = s + 1
y = f(a)
a ∈ ℝ"##;

LocalsNextLine, PlainLocalsNextLine = r##"f(x) = s t
 where x ∈ ℝ, s = x²,
 t = 3
y = f(a)
a ∈ ℝ"##;

FunctionVectorResult, PlainFunctionVectorResult = r##"f(x) = (x, x², 1) where x ∈ ℝ
y = f(a)
z = y_2
a ∈ ℝ"##;

PiecewiseFunction, PlainPiecewiseFunction = r##"f(x) = { x if x > 0
         -x otherwise
where x ∈ ℝ
y = f(a) + f(b)
a,b ∈ ℝ"##;

MatrixOfFunctions, PlainMatrixOfFunctions = r##"sin, cos from trigonometry
R(t) = [cos(t) -sin(t)
        sin(t) cos(t)] where t ∈ ℝ
y = R(a) u
a ∈ ℝ
u ∈ ℝ^2"##;

SequenceFunctions, PlainSequenceFunctions = r##"d(p, q) = ‖p - q‖ where p, q ∈ ℝ^n
y = ∑_i ∑_j d(x_i, x_j)
x_i ∈ ℝ^3"##;

SetOfVectors, PlainSetOfVectors = r##"y = ∑_(v ∈ S) ‖v‖
where
S ∈ {ℝ^(3)}"##;

SetOfTriples, PlainSetOfTriples = r##"y = ∑_(i,j,k ∈ S) i j k
where
S ∈ {ℤ^3}"##;

TupleParameter, PlainTupleParameter = r##"y = a_1 + a_2
where
a ∈ ℝ × ℤ"##;

DestructureSet, PlainDestructureSet = r##"a, b = S
where
S ∈ {ℤ}"##;

DestructureVector, PlainDestructureVector = r##"a, b, c = u
where
u ∈ ℝ^3"##;

SvdValues, PlainSvdValues = r##"svd from linearalgebra
U, s, W = svd(A)
where
A ∈ ℝ^(3×3)"##;

NullSpace, PlainNullSpace = r##"null from linearalgebra
N = null(A)
y = ‖A N‖
z = ‖Nᵀ N - I_2‖
where
A ∈ ℝ^(2×3)"##;

OrthogonalBasis, PlainOrthogonalBasis = r##"orth from linearalgebra
N = orth(A)
y = ‖N Nᵀ A - A‖
where
A ∈ ℝ^(2×3)"##;

InverseVec, PlainInverseVec = r##"vec, vec⁻¹ from linearalgebra
y = vec⁻¹_x(2 vec(x))
where
x_i ∈ ℝ^3"##;

PositivePart, PlainPositivePart = r##"psd from linearalgebra
B = psd(A)
where
A ∈ ℝ^(3×3)"##;

RectangularDiag, PlainRectangularDiag = r##"diag from linearalgebra
D = diag(x, 3, 4)
where
x ∈ ℝ^3"##;

IdentityNamed, PlainIdentityNamed = r##"y = I_n + A
where
A ∈ ℝ^(n×n)"##;

OwnIdentitySymbol, PlainOwnIdentitySymbol = r##"y = I A
I = 3
where
A ∈ ℝ^(n×n)"##;

OwnTransposeLetter, PlainOwnTransposeLetter = r##"y = A^T A + T I_2
T = 2
where
A ∈ ℝ^(2×2)"##;

LeftAssociative, PlainLeftAssociative = r##"y = a/b c + a - b - c
where
a,b,c ∈ ℝ"##;

PowerTower, PlainPowerTower = r##"y = 2^a^b + 2^(a+1)
where
a,b ∈ ℝ"##;

PowerJuxtaposed, PlainPowerJuxtaposed = r##"y = a²b + a^2b
where
a,b ∈ ℝ"##;

PowerThenCross, PlainPowerThenCross = r##"y = a^2 u × v
where
a ∈ ℝ
u,v ∈ ℝ^3"##;

TripleProduct, PlainTripleProduct = r##"y = u × v ⋅ w
z = w⋅(u × v)
where
u,v,w ∈ ℝ^3"##;

SqrtForms, PlainSqrtForms = r##"y = √a b + √(a b) + sqrt(a)
where
a,b ∈ ℝ"##;

SumOfNegatives, PlainSumOfNegatives = r##"y = ∑_i -w_i a
where
w_i ∈ ℝ
a ∈ ℝ"##;

SumDivided, PlainSumDivided = r##"y = ∑_i w_i a / b + 1
where
w_i ∈ ℝ
a,b ∈ ℝ"##;

EmptySum, PlainEmptySum = r##"y = ∑_(i ∈ S) i
z = ∑_(i=3)^2 i
where
S ∈ {ℤ}"##;

SumOverUnion, PlainSumOverUnion = r##"y = ∑_(k ∈ S ∪ W) k + ∑_(k ∈ {1,2}) k
where
S,W ∈ {ℤ}"##;

BuilderForms, PlainBuilderForms = r##"A = {k | k ∈ S, k > 2}
B = {2k for k ∈ S if k > 2}
C = {k ∀ k ∈ S}
where
S ∈ {ℤ}"##;

BuilderPairs, PlainBuilderPairs = r##"A = {i + j for i,j ∈ S if i < j}
where
S ∈ {ℤ×ℤ}"##;

SetComparison, PlainSetComparison = r##"y = { 1 if S = W
 0 otherwise
where
S,W ∈ {ℤ}"##;

SetItem, PlainSetItem = r##"y = S_1
where
S ∈ {ℤ}"##;

SumWithConditionSet, PlainSumWithConditionSet = r##"y = ∑_(i for i ∈ S and i > 1) x_i
where
S ∈ {ℤ}
x ∈ ℝ^n"##;

MatrixByScalarFunction, PlainMatrixByScalarFunction = r##"A_ij = f(i, j)
f(i,j) = i + 10j where i,j ∈ ℤ
A ∈ ℝ^(2×3)"##;

DiagonalThenEntries, PlainDiagonalThenEntries = r##"y_i = A_ii
where
A ∈ ℝ^(n×n)"##;

TraceBySum, PlainTraceBySum = r##"y = ∑_i A_ii
where
A ∈ ℝ^(n×n)"##;

ShiftedSum, PlainShiftedSum = r##"y = ∑_(i for i < n) (x_i - x_(i+1))²
where
x ∈ ℝ^n
n ∈ ℤ"##;

BlockOfVectors, PlainBlockOfVectors = r##"A = [u v]
B = [uᵀ; vᵀ]
where
u,v ∈ ℝ^3"##;

ZeroBlockNamed, PlainZeroBlockNamed = r##"B = [A 0_n,m; 0_m,n I_m]
where
A ∈ ℝ^(n×n)
m ∈ ℤ"##;

SizeProduct, PlainSizeProduct = r##"y = vec(A)
vec from linearalgebra
where
A ∈ ℝ^(n×m)"##;

CrossOfSums, PlainCrossOfSums = r##"y = (u + v) × (u - v)
where
u,v ∈ ℝ^3"##;

Registration, PlainRegistration = r##"q = ∑_i ‖R x_i + t - y_i‖²
where
R ∈ ℝ^(3×3)
t ∈ ℝ^3
x_i ∈ ℝ^3
y_i ∈ ℝ^3"##;

NormalEquations, PlainNormalEquations = r##"x = (AᵀA)⁻¹Aᵀb
z = (AᵀA)⁻¹(Aᵀb)
where
A ∈ ℝ^(m×n)
b ∈ ℝ^m"##;

Kalman, PlainKalman = r##"K = P Hᵀ (H P Hᵀ + R)⁻¹
Q = (I_4 - K H) P
where
P ∈ ℝ^(4×4)
H ∈ ℝ^(2×4)
R ∈ ℝ^(2×2)"##;

Lagrangian, PlainLagrangian = r##"y = ½ ‖x‖² + λᵀ(A x - b) + ρ/2 ‖A x - b‖²
where
x ∈ ℝ^n
λ ∈ ℝ^m
A ∈ ℝ^(m×n)
b ∈ ℝ^m
ρ ∈ ℝ"##;

Softmax, PlainSoftmax = r##"s_i = exp(x_i)/∑_j exp(x_j)
where
x ∈ ℝ^n"##;

Gaussian, PlainGaussian = r##"p = exp(-½ (x - μ)ᵀΣ⁻¹(x - μ))/√((2π)^n |Σ|)
where
x, μ ∈ ℝ^n
Σ ∈ ℝ^(n×n)"##;

Householder, PlainHouseholder = r##"H = I_n - 2 (v vᵀ)/(vᵀv)
y = H x
where
v, x ∈ ℝ^n"##;

Skew, PlainSkew = r##"S = [0 -u_3 u_2; u_3 0 -u_1; -u_2 u_1 0]
y = S v
where
u,v ∈ ℝ^3"##;

Arap, PlainArap = r##"E = ∑_i ∑_j w_ij ‖(p_i - p_j) - R_i(q_i - q_j)‖²
where
w ∈ ℝ^(n×n)
p_i,q_i ∈ ℝ^3
R_i ∈ ℝ^(3×3)"##;

NamesWithBackticks, PlainNamesWithBackticks = r##"`my name` = 2`x*` + `a_b`
where
`x*` ∈ ℝ
`a_b` ∈ ℝ"##;

ParenthesisedIndex, PlainParenthesisedIndex = r##"y = A_(i+1,2) + x_(n-1)
i = 1
where
A ∈ ℝ^(2×2)
x ∈ ℝ^n"##;

EntriesWithSizes, PlainEntriesWithSizes = r##"A_ij = x_i y_j
where
x ∈ ℝ^n
y ∈ ℝ^m"##;

SemicolonItems, PlainSemicolonItems = r##"a = 1; b = a + 1; c = b²"##;

Comment, PlainComment = r##"// a comment
a = 1 // another
b = 2a"##;

BreakAfterOperator, PlainBreakAfterOperator = r##"y = a +
 b
where
a,b ∈ ℝ"##;

BreaksInParentheses, PlainBreaksInParentheses = r##"y = (a
 + b)
where
a,b ∈ ℝ"##;

SumInsideNorm, PlainSumInsideNorm = r##"y = ‖∑_i x_i‖²/∑_i ‖x_i‖²
where
x_i ∈ ℝ^3"##;

FunctionOfMatrixAny, PlainFunctionOfMatrixAny = r##"f(A) = tr(A) where A ∈ ℝ^(n×n)
tr from linearalgebra
y = f(B) + f(C)
B ∈ ℝ^(2×2)
C ∈ ℝ^(3×3)"##;

MutualOrder, PlainMutualOrder = r##"c = a + b
b = 2a
a = 3"##;

IntMapping, PlainIntMapping = r##"y = ∑_i k_i x_i
where
k_i ∈ ℤ
x_i ∈ ℝ"##;

VectorIndexVector, PlainVectorIndexVector = r##"y_i = x_(k_i)
where
x ∈ ℝ^n
k_i ∈ ℤ"##;

DetOfLiteral, PlainDetOfLiteral = r##"y = |[a b; c a]|
z = |[u v w]|
where
a,b,c ∈ ℝ
u,v,w ∈ ℝ^3"##;

ModFree, PlainModFree = r##"y = log_2(8) + log_10(100) + ln(1)"##;

Pi, PlainPi = r##"y = 2π r
where
r ∈ ℝ"##;

SequenceOfSequences, PlainSequenceOfSequences = r##"y = ∑_i ∑_j x_i,j
where
x_i ∈ ℝ^3"##;

MinOfExpression, PlainMinOfExpression = r##"y = min({‖x_i‖ for i ∈ S})
where
S ∈ {ℤ}
x_i ∈ ℝ^3"##;

ArgminSet, PlainArgminSet = r##"y = argmin_(i ∈ S) x_i
where
S ∈ {ℤ}
x ∈ ℝ^n"##;

MaxBox, PlainMaxBox = r##"y = max_(x ∈ ℝ) x (1 - x) s.t. x ≥ 0; x ≤ 1"##;

Rosenbrock, PlainRosenbrock = r##"y = argmin_(x ∈ ℝ^2) (1 - x_1)² + 100(x_2 - x_1²)²"##;

TwoVariables, PlainTwoVariables = r##"y = min_(a ∈ ℝ, b ∈ ℝ) (a - 1)² + (b + 2)² + 3"##;

SineIntegral, PlainSineIntegral = r##"sin from trigonometry
y = ∫_[0, π] sin(t) 𝕕t"##;

NestedIntegral, PlainNestedIntegral = r##"y = ∫_0^1 ∫_0^2 s t 𝕕s 𝕕t"##;

IntegralExpression, PlainIntegralExpression = r##"sin from trigonometry
y = 2 ∫_a^b t^2 + 1 𝕕t
where
a,b ∈ ℝ"##;

RaggedMatrices, PlainRaggedMatrices = r##"y = ∑_i tr(A_iᵀ A_i)
tr from linearalgebra
where
A_i ∈ ℝ^(m_i×n_i)"##;

SparseDeclaredRows, PlainSparseDeclaredRows = r##"A ∈ ℝ^(n×n)
n ∈ ℤ
A_ij = { 1 if i = j
         0.5 if (i,j) ∈ P
P ∈ {ℤ×ℤ}
y = A x
x ∈ ℝ^n"##;

MutualRecursion, PlainMutualRecursion = r##"A(n) = { 1 if n = 0
         n - B(A(n - 1)) otherwise where n ∈ ℤ
B(n) = { 0 if n = 0
         n - A(B(n - 1)) otherwise where n ∈ ℤ
y_i = A(k_i)
z_i = B(k_i)
k_i ∈ ℤ"##;

RecursionInACircle, PlainRecursionInACircle = r##"f(n) = { 1 if n = 0
         g(n - 1, n)/2 otherwise where n ∈ ℤ
g(n, m) = h(n) + a m where n, m ∈ ℤ
h(n) = f(n) where n ∈ ℤ
y = f(4)
z = h(3)
a ∈ ℝ"##;

RecursionFromIntegerToReal, PlainRecursionFromIntegerToReal = r##"f(n) = { 1 if n = 0
         f(n - 1)/2 + 1 otherwise where n ∈ ℤ
y = f(3)"##;

SizesOfSequences, PlainSizesOfSequences = r##"k, r = #x
l, s, t = #q
n = #w
m = |x|
p, u = #y
where
x_i ∈ ℝ³
q_i ∈ ℝ^(2×c)
w_i ∈ ℝ
y_j ∈ ℝ^(d_j)"##;

ColumnsAndVectors, PlainColumnsAndVectors = r##"f(u) = u_1 + 2u_3 where u ∈ ℝ³
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
a ∈ ℝ"##;

MatrixBeforeVector, PlainMatrixBeforeVector = r##"f(A) = A_1,1 where A ∈ ℝ^(n×m)
f(u) = u_1 + 10 where u ∈ ℝ^n
y = f([a; b])
z = f((a, b))
where
a, b ∈ ℝ"##;

FunctionByAnotherName, PlainFunctionByAnotherName = r##"g = f
k = g
ψ = φ
y = k(a) + ∑_i ψ_i(a)
where
f ∈ ℝ → ℝ
φ_i ∈ ℝ → ℝ
a ∈ ℝ"##;

SetAddedTo, PlainSetAddedTo = r##"T = S
T += {7, 2}
where
S ∈ {ℤ}"##;

OptimaInCases, PlainOptimaInCases = r##"y = { min_(t ∈ ℝ) (t - a)² + 1 if a > 2
      min_(t ∈ ℝ) (t - a)² + 2 s.t. t ≥ 3
      if a > 1
      0 otherwise
z = { argmin_(k ∈ ℤ) (k - b)²
        s.t. -3 ≤ k
             k ≤ 3
      otherwise
where
a, b ∈ ℝ"##;

RankedOverloads, PlainRankedOverloads = r##"g(k) = 1 where k ∈ ℤ
g(k) = 2 where k ∈ ℝ
g(u) = 3 where u ∈ ℝ³
g(u) = 4 where u ∈ ℝ^n
h(k) = 1 + k where k ∈ ℝ
h(u) = 5 where u ∈ ℝ³
y = (g(1), g(1.5), g(p), g(q), h(2), h(p))
where
p ∈ ℝ³
q ∈ ℝ²"##;

FunctionsOfFunctions, PlainFunctionsOfFunctions = r##"twice(g, x) = g(g(x)) where g ∈ ℝ → ℝ, x ∈ ℝ
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
v ∈ ℝ^m"##;

SetsOfIntegersAndReals, PlainSetsOfIntegersAndReals = r##"U ∈ {ℤ}
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
      T otherwise"##;

RootsOfMatrices, PlainRootsOfMatrices = r##"B = A^(½)
C = A^p
D = A^(-0.5)
E = B B
where
A ∈ ℝ^(3×3)
p ∈ ℝ"##;

RaggedTotal, PlainRaggedTotal = r##"s = ∑_i ∑_j x_i,j
t = ∑_i ∑_(j = 1)^(n_i) j x_i,j
where
x_i ∈ ℝ^(n_i)"##;

RaggedSystems, PlainRaggedSystems = r##"y_i = A_i⁻¹ x_i
s = ∑_i x_iᵀ A_i x_i
where
x_i ∈ ℝ^(n_i)
A_i ∈ ℝ^(n_i×n_i)"##;

SumOverSetAndLater, PlainSumOverSetAndLater = r##"y = ∑_(i ∈ S) ∑_(j for j > i) a_i a_j
where
S ∈ {ℤ}
a_i ∈ ℝ"##;

EntriesInSet, PlainEntriesInSet = r##"y_i = { a_i if i ∈ S
        -1 otherwise
where
a_i ∈ ℝ
S ∈ {ℤ}"##;

MatrixByOrder, PlainMatrixByOrder = r##"M_ij = { 1 if i = j
         a_i a_j if i < j
         0 otherwise
where
a ∈ ℝ^n"##;

Bidiagonal, PlainBidiagonal = r##"M ∈ ℝ^(n×n)
M_ij = { 1 if i = j
         a_i if j = i + 1
         0 otherwise
y = M a
where
a ∈ ℝ^n"##;

TriangularSum, PlainTriangularSum = r##"y = ∑_(i=1)^n ∑_(j=1)^i A_ij
where
A ∈ ℝ^(n×n)"##;

SignedIdentityBlocks, PlainSignedIdentityBlocks = r##"B = [I_m A; Aᵀ -I]
C = [A 0_(m,2); 1_(2,n) [1 2; 3 4]]
where
A ∈ ℝ^(m×n)"##;

ColumnsOverTheirSums, PlainColumnsOverTheirSums = r##"y_i = ‖A_i,*‖
s_j = ∑_i A_ij
B_*,j = A_*,j / s_j
z = B_*,1 + A_*,2
where
A ∈ ℝ^(m×n)"##;

WeightedCovariance, PlainWeightedCovariance = r##"A = ∑_i w_i (x_i - μ)(x_i - μ)ᵀ
μ = (∑_i w_i x_i) / ∑_i w_i
where
x_i ∈ ℝ^3
w_i ∈ ℝ"##;

VectorisedKronecker, PlainVectorisedKronecker = r##"vec from linearalgebra
y = (A ⊗ I_2) vec(B)
z = vec(B Aᵀ)
where
A ∈ ℝ^(2×2)
B ∈ ℝ^(2×2)"##;

AppendedOne, PlainAppendedOne = r##"y = A (x, 1)
z = A [x; 1]
where
A ∈ ℝ^(m×(n+1))
x ∈ ℝ^n"##;

RotationAboutAxis, PlainRotationAboutAxis = r##"R = I_3 + sin(θ) K + (1 - cos(θ)) K²
K = [0 -k_3 k_2
     k_3 0 -k_1
     -k_2 k_1 0]
sin, cos from trigonometry
where
k ∈ ℝ^3
θ ∈ ℝ"##;

DifferenceOfIndices, PlainDifferenceOfIndices = r##"y = ∑_(i = 2)^n (a_i - a_(i-1))² + a_(n) a_1
z = x_(b_2) + M_(b_1, 2) + x_(n-1)
where
a ∈ ℝ^n
x ∈ ℝ^n
b ∈ ℤ^3
M ∈ ℝ^(4×4)"##;

IntegersAndRealsInSets, PlainIntegersAndRealsInSets = r##"S = {1, 2, 3} ∪ {k² for k ∈ T if k > 1}
y = ∑_(k ∈ S \ {1}) k
z = |S|
R = {0.5} ∩ T
where
T ∈ {ℤ}"##;

SparseStaysSparse, PlainSparseStaysSparse = r##"C = A²
D = A ∘ B
E = A + B
F = A ∘ G
H = A³ - 2B
y = A² b
s = trace(A ∘ B) + |A|
trace from linearalgebra
where
A ∈ ℝ^(n×n) sparse
B ∈ ℝ^(n×n) sparse
G ∈ ℝ^(n×n)
b ∈ ℝ^n"##;

SparseSolves, PlainSparseSolves = r##"y = A \ b + A⁻¹ b
X = A⁻¹ G
z = bᵀ A⁻¹ b
where
A ∈ ℝ^(n×n) sparse
b ∈ ℝ^n
G ∈ ℝ^(n×n)"##;

NormsWithPowers, PlainNormsWithPowers = r##"y = ||x||_p + ||x||_3^2 + ‖x‖_∞ + ||A||_F² + ||x||_P^2 + ‖x‖₁
where
x ∈ ℝ^n
p ∈ ℝ
A ∈ ℝ^(n×m)
P ∈ ℝ^(n×n)"##;

CallbacksOfSequences, PlainCallbacksOfSequences = r##"y = ∑_i f(x_i, a)
z_i = f(x_i, i)
where
f ∈ ℝ^3, ℝ → ℝ
x_i ∈ ℝ^3
a ∈ ℝ"##;

FunctionOfTwoSubscriptsAndAVector, PlainFunctionOfTwoSubscriptsAndAVector = r##"K_ij(x) = x_i x_j where i, j ∈ ℤ, x ∈ ℝ^n
y = K_1,2(u) + K(1, 3, u) + K_2(3, u)
where
u ∈ ℝ^4"##;

ProductsOverIndices, PlainProductsOverIndices = r##"y = (∏_(i=1)^n (x - a_i)) / ∏_i b_i
z = ∏_(i for i ≠ 2) a_i
where
a ∈ ℝ^n
b ∈ ℝ^n
x ∈ ℝ"##;

LeastOfEverything, PlainLeastOfEverything = r##"y = min(a, b, 3) + max({a, b}) - min(x) + max(A)
where
a, b ∈ ℝ
x ∈ ℝ^n
A ∈ ℝ^(n×n)"##;

HalvesOfIntegers, PlainHalvesOfIntegers = r##"y = n/2 + 1/2
k = n - 1
z = ∑_(i = 1)^k i/n
where
n ∈ ℤ"##;

SequencesAsVectors, PlainSequencesAsVectors = r##"y = A w
z = A \ w
t = b⋅w + (A w)⋅b
d = b - w
where
A ∈ ℝ^(n×n)
w_i ∈ ℝ
b ∈ ℝ^n"##;

PairsOfASet, PlainPairsOfASet = r##"y = ∑_((i,j) ∈ P) a_i b_j
z = ∑_(p ∈ P) a_(p_1) b_(p_2)
Q = {tuple(j, i) for i, j ∈ P if i < j}
c = |Q|
where
P ∈ {ℤ×ℤ}
a ∈ ℝ^n
b ∈ ℝ^m"##;

DegreesAndLaplacian, PlainDegreesAndLaplacian = r##"A ∈ ℝ^(n×n)
A_ij = { 1 if (i,j) ∈ P
         0 otherwise
d_i = ∑_j A_ij
D_ii = d_i
L = D - A
q = xᵀ L x
where
P ∈ {ℤ×ℤ} index
x ∈ ℝ^n"##;

ProjectionOutOf, PlainProjectionOutOf = r##"v = (I_n - u uᵀ/(u⋅u)) w
c = <u, v> + ⟨v, v⟩_P
where
u, w ∈ ℝ^n
P ∈ ℝ^(n×n)"##;

ColumnsByAssignment, PlainColumnsByAssignment = r##"A ∈ ℝ^(3×2)
A_*,1 = u
A_*,2 = v
G = AᵀA
where
u, v ∈ ℝ^3"##;

LocalsOfLocals, PlainLocalsOfLocals = r##"f(x) = g(x) + 1 where x ∈ ℝ
g(x) = h x where x ∈ ℝ,
  h = 2 k,
  k = x + s
s = ∑_i w_i
y = f(3)
where
w_i ∈ ℝ"##;

MovingAverage, PlainMovingAverage = r##"y ∈ ℝ^n
y_i = 1/(2k+1) ∑_(j = -k)^k a_(max(1, min(n, i + j)))
where
a ∈ ℝ^n
k ∈ ℤ
b ∈ ℝ^n"##;

BlocksWithMultiplesOfIdentities, PlainBlocksWithMultiplesOfIdentities = r##"C = [A -I
     -2aI Aᵀ]
D = [A (a I); I 0]
E = [I -I]
F = [B -I; -aI 0]
where
A ∈ ℝ^(2×2)
a ∈ ℝ
B ∈ ℝ^(n×n) sparse"##;

}

for_both! {
#[test]
fn add_scalars() {
    let module = AddScalars::new(1.5_f64, -0.75_f64).unwrap();
    check("c", &module.c(), &[0.75]);
}

#[test]
fn add_matrices() {
    let module = AddMatrices::new(SMatrix::<f64, 3, 2>::from_column_slice(&[-0.708, 0.36, -0.239, -1.399, 0.42, -1.042]), SMatrix::<f64, 3, 2>::from_column_slice(&[-1.474, -1.418, 1.536, 1.38, -1.23, 0.566])).unwrap();
    check("A", &module.A(), &[-2.182, -1.0579999999999998, 1.2970000000000002, -0.019000000000000128, -0.81, -0.4760000000000001]);
}

#[test]
fn side_by_side() {
    let module = SideBySide::new(DMat3::from_cols_array(&[0.5, -1.099, -1.979, 1.589, -0.799, 1.285, 1.103, 1.494, 1.188]), DMat3::from_cols_array(&[-0.128, -0.981, 0.214, -0.788, -0.22, 1.982, -0.886, 0.018, 1.171])).unwrap();
    check("B", &module.B(), &[0.5, -1.099, -1.979, 1.589, -0.799, 1.285, 1.103, 1.494, 1.188, -0.128, -0.981, 0.214, -0.788, -0.22, 1.982, -0.886, 0.018, 1.171]);
}

#[test]
fn on_top() {
    let module = OnTop::new(DMat2::from_cols_array(&[1.669, 0.056, 0.517, -0.013]), DMat2::from_cols_array(&[-1.01, -1.23, -1.953, 0.768])).unwrap();
    check("B", &module.B(), &[1.669, 0.056, -1.01, -1.23, 0.517, -0.013, -1.953, 0.768]);
}

#[test]
fn block_zero() {
    let module = BlockZero::new(DMat2::from_cols_array(&[1.669, 0.056, 0.517, -0.013]), DMat2::from_cols_array(&[-1.01, -1.23, -1.953, 0.768])).unwrap();
    check("B", &module.B(), &[1.669, 0.056, 0.0, 0.0, 0.517, -0.013, 0.0, 0.0, 0.0, 0.0, -1.01, -1.23, 0.0, 0.0, -1.953, 0.768]);
}

#[test]
fn block_affine() {
    let module = BlockAffine::new(DMat3::from_cols_array(&[0.5, -1.099, -1.979, 1.589, -0.799, 1.285, 1.103, 1.494, 1.188]), DVec3::new(-1.198, -0.522, -1.985)).unwrap();
    check("B", &module.B(), &[0.5, -1.099, -1.979, 0.0, 1.589, -0.799, 1.285, 0.0, 1.103, 1.494, 1.188, 0.0, -1.198, -0.522, -1.985, 1.0]);
}

#[test]
fn block_ones() {
    let module = BlockOnes::new(DMatrix::<f64>::from_column_slice(4, 5, &[-0.708, 0.36, -0.239, -1.14, -1.399, 0.42, -1.042, 0.687, 1.265, 0.552, -0.39, -0.798, -0.482, 0.706, -1.613, 1.496, 1.915, -1.397, 1.871, 0.649])).unwrap();
    check("C", &module.C(), &[1.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, -0.708, 0.36, -0.239, -1.14, 0.0, 0.0, 0.0, 0.0, 0.0, -1.399, 0.42, -1.042, 0.687, 0.0, 0.0, 0.0, 0.0, 0.0, 1.265, 0.552, -0.39, -0.798, 0.0, 0.0, 0.0, 0.0, 0.0, -0.482, 0.706, -1.613, 1.496, 0.0, 0.0, 0.0, 0.0, 0.0, 1.915, -1.397, 1.871, 0.649, 0.0, 0.0, 0.0, 0.0, 0.0]);
}

#[test]
fn block_row_one() {
    let module = BlockRowOne::new(SMatrix::<f64, 3, 2>::from_column_slice(&[-0.708, 0.36, -0.239, -1.399, 0.42, -1.042])).unwrap();
    check("y", &module.y(), &[-0.708, 0.36, -0.239, 0.0, -1.399, 0.42, -1.042, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0]);
}

#[test]
fn block_column() {
    let module = BlockColumn::new(DMat3::from_cols_array(&[0.5, -1.099, -1.979, 1.589, -0.799, 1.285, 1.103, 1.494, 1.188]), DVec3::new(-1.198, -0.522, -1.985)).unwrap();
    check("C", &module.C(), &[0.5, -1.099, -1.979, -1.198, 1.589, -0.799, 1.285, -0.522, 1.103, 1.494, 1.188, -1.985, -1.198, -0.522, -1.985, 1.0]);
}

#[test]
fn row() {
    let module = Row::new(1.5_f64, -0.75_f64, 2.25_f64).unwrap();
    check("A", &module.A(), &[1.5, -0.75, 2.25]);
}

#[test]
fn sum_of_sequence() {
    let module = SumOfSequence::new(vec![0.559_f64, 0.967_f64, -1.634_f64, 0.165_f64, 0.031_f64]).unwrap();
    check("b", &module.b(), &[0.08800000000000013]);
}

#[test]
fn sum_filtered() {
    let module = SumFiltered::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("b", &module.b(), &[-0.47099999999999986]);
}

#[test]
fn sum_filtered_twice() {
    let module = SumFilteredTwice::new(SVector::<f64, 5>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("b", &module.b(), &[-0.6669999999999999]);
}

#[test]
fn sum_nested() {
    let module = SumNested::new(DMatrix::<f64>::from_column_slice(4, 5, &[-0.708, 0.36, -0.239, -1.14, -1.399, 0.42, -1.042, 0.687, 1.265, 0.552, -0.39, -0.798, -0.482, 0.706, -1.613, 1.496, 1.915, -1.397, 1.871, 0.649])).unwrap();
    check("b", &module.b(), &[0.7129999999999996]);
}

#[test]
fn sum_off_diagonal() {
    let module = SumOffDiagonal::new(DMatrix::<f64>::from_column_slice(5, 5, &[13.914, 1.72, -1.661, -4.641, 1.417, 1.72, 11.257, -3.451, 3.467, 6.046, -1.661, -3.451, 8.616, -1.985, -4.013, -4.641, 3.467, -1.985, 13.767, 4.423, 1.417, 6.046, -4.013, 4.423, 13.699])).unwrap();
    check("b", &module.b(), &[2.6439999999999984]);
}

#[test]
fn sum_outer() {
    let module = SumOuter::new(vec![-0.669_f64, -0.407_f64, -1.188_f64, -1.797_f64], vec![DVec3::new(-0.353, 1.691, -1.725), DVec3::new(-0.28, 0.078, 1.804), DVec3::new(-0.996, 1.224, 0.706), DVec3::new(0.868, 0.518, 1.886)]).unwrap();
    check("A", &module.A(), &[-2.6476901569999995, 1.0485515909999998, -2.308189153, 1.0485515909999998, -4.177480293, -0.8879921369999992, -2.308189153, -0.8879921369999992, -10.299304217]);
}

#[test]
fn covariance() {
    let module = Covariance::new(vec![DVec3::new(-0.353, 1.691, -1.725), DVec3::new(-0.28, 0.078, 1.804), DVec3::new(-0.996, 1.224, 0.706), DVec3::new(0.868, 0.518, 1.886)], 4_i64).unwrap();
    check("C", &module.C(), &[0.4509171874999999, -0.18006881249999995, 0.3864586874999999, -0.18006881249999995, 0.3875711875, -0.8199103125, 0.3864586874999999, -0.8199103125, 2.1254781874999997]);
}

#[test]
fn entries() {
    let module = Entries::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031]), DVector::<f64>::from_column_slice(&[1.485, -0.555, 0.393, -1.763, -0.449])).unwrap();
    check("a", &module.a(), &[0.8301150000000002, -0.5366850000000001, -0.642162, -0.290895, -0.013919]);
}

#[test]
fn entries_of_matrix() {
    let module = EntriesOfMatrix::new(DMatrix::<f64>::from_column_slice(4, 5, &[-0.708, 0.36, -0.239, -1.14, -1.399, 0.42, -1.042, 0.687, 1.265, 0.552, -0.39, -0.798, -0.482, 0.706, -1.613, 1.496, 1.915, -1.397, 1.871, 0.649]), DMatrix::<f64>::from_column_slice(4, 5, &[-1.474, -1.418, 1.536, -1.042, 1.38, -1.23, 0.566, -1.848, 1.78, 1.712, 0.279, 1.505, 1.616, 0.209, -0.495, -0.129, 0.279, -1.278, -0.356, 0.191])).unwrap();
    check("C", &module.C(), &[2.043592, 0.48952000000000007, 0.632896, 2.18788, -0.9306199999999998, 0.48340000000000005, 0.41022800000000004, -0.26957600000000026, 3.2517, 1.945024, 0.8911899999999999, -0.20099, 0.22108799999999995, 1.147554, 1.798435, 0.807016, 1.5342850000000001, 2.785366, 0.333924, 1.123959]);
}

#[test]
fn transposed_entries() {
    let module = TransposedEntries::new(DMatrix::<f64>::from_column_slice(4, 5, &[-0.708, 0.36, -0.239, -1.14, -1.399, 0.42, -1.042, 0.687, 1.265, 0.552, -0.39, -0.798, -0.482, 0.706, -1.613, 1.496, 1.915, -1.397, 1.871, 0.649])).unwrap();
    check("C", &module.C(), &[-0.708, -1.399, 1.265, -0.482, 1.915, 0.36, 0.42, 0.552, 0.706, -1.397, -0.239, -1.042, -0.39, -1.613, 1.871, -1.14, 0.687, -0.798, 1.496, 0.649]);
}

#[test]
fn matrix_product_by_entries() {
    let module = MatrixProductByEntries::new(DMatrix::<f64>::from_column_slice(4, 5, &[-0.708, 0.36, -0.239, -1.14, -1.399, 0.42, -1.042, 0.687, 1.265, 0.552, -0.39, -0.798, -0.482, 0.706, -1.613, 1.496, 1.915, -1.397, 1.871, 0.649]), DMatrix::<f64>::from_column_slice(5, 4, &[-1.474, 1.38, 1.78, 1.616, 0.279, -1.418, -1.23, 1.712, 0.209, -1.278, 1.536, 0.566, 0.279, -0.495, -0.356, -1.042, -1.848, 1.505, -0.129, 0.191])).unwrap();
    check("C", &module.C(), &[1.120045, 1.782653, -3.864473, 3.806587, 2.3422859999999996, 1.850864, -1.775373, -1.1114240000000004, -1.9695369999999999, 1.09255, -0.9333269999999999, -2.5564039999999997, 5.654856, -0.678421, 2.1531420000000003, -1.351711]);
}

#[test]
fn hadamard() {
    let module = Hadamard::new(DMatrix::<f64>::from_column_slice(4, 5, &[-0.708, 0.36, -0.239, -1.14, -1.399, 0.42, -1.042, 0.687, 1.265, 0.552, -0.39, -0.798, -0.482, 0.706, -1.613, 1.496, 1.915, -1.397, 1.871, 0.649]), DMatrix::<f64>::from_column_slice(4, 5, &[-1.474, -1.418, 1.536, -1.042, 1.38, -1.23, 0.566, -1.848, 1.78, 1.712, 0.279, 1.505, 1.616, 0.209, -0.495, -0.129, 0.279, -1.278, -0.356, 0.191])).unwrap();
    check("C", &module.C(), &[1.0435919999999999, -0.5104799999999999, -0.367104, 1.18788, -1.9306199999999998, -0.5166, -0.589772, -1.2695760000000003, 2.2517, 0.9450240000000001, -0.10881000000000002, -1.20099, -0.778912, 0.147554, 0.798435, -0.19298400000000002, 0.534285, 1.785366, -0.666076, 0.123959]);
}

#[test]
fn kronecker() {
    let module = Kronecker::new(DMatrix::<f64>::from_column_slice(4, 5, &[-0.708, 0.36, -0.239, -1.14, -1.399, 0.42, -1.042, 0.687, 1.265, 0.552, -0.39, -0.798, -0.482, 0.706, -1.613, 1.496, 1.915, -1.397, 1.871, 0.649]), DMatrix::<f64>::from_column_slice(2, 2, &[1.669, 0.056, 0.517, -0.013])).unwrap();
    check("C", &module.C(), &[-1.181652, -0.039647999999999996, 0.60084, 0.02016, -0.398891, -0.013384, -1.9026599999999998, -0.06384, -0.366036, 0.009203999999999999, 0.18612, -0.004679999999999999, -0.12356299999999999, 0.0031069999999999995, -0.58938, 0.014819999999999998, -2.334931, -0.078344, 0.7009799999999999, 0.02352, -1.739098, -0.058352, 1.146603, 0.038472000000000006, -0.723283, 0.018187, 0.21714, -0.00546, -0.538714, 0.013545999999999999, 0.355179, -0.008931, 2.111285, 0.07084, 0.9212880000000001, 0.030912000000000002, -0.65091, -0.021840000000000002, -1.331862, -0.044688000000000005, 0.654005, -0.016444999999999998, 0.285384, -0.007176, -0.20163, 0.00507, -0.41256600000000004, 0.010374, -0.804458, -0.026992, 1.1783139999999999, 0.039536, -2.692097, -0.090328, 2.496824, 0.083776, -0.249194, 0.006266, 0.365002, -0.009177999999999999, -0.833921, 0.020968999999999998, 0.773432, -0.019448, 3.196135, 0.10724, -2.3315930000000002, -0.078232, 3.122699, 0.10477600000000001, 1.0831810000000002, 0.036344, 0.990055, -0.024895, -0.722249, 0.018161, 0.967307, -0.024322999999999997, 0.335533, -0.008437]);
}

#[test]
fn kronecker_vectors() {
    let module = KroneckerVectors::new(DVec3::new(-1.198, -0.522, -1.985), DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("C", &module.C(), &[-0.669682, -1.158466, 1.9575319999999998, -0.19767, -0.037138, -0.29179800000000006, -0.5047740000000001, 0.8529479999999999, -0.08613000000000001, -0.016182000000000002, -1.1096150000000002, -1.919495, 3.24349, -0.327525, -0.061535]);
}

#[test]
fn frobenius() {
    let module = Frobenius::new(DMatrix::<f64>::from_column_slice(4, 5, &[-0.708, 0.36, -0.239, -1.14, -1.399, 0.42, -1.042, 0.687, 1.265, 0.552, -0.39, -0.798, -0.482, 0.706, -1.613, 1.496, 1.915, -1.397, 1.871, 0.649]), DMatrix::<f64>::from_column_slice(4, 5, &[-1.474, -1.418, 1.536, -1.042, 1.38, -1.23, 0.566, -1.848, 1.78, 1.712, 0.279, 1.505, 1.616, 0.209, -0.495, -0.129, 0.279, -1.278, -0.356, 0.191])).unwrap();
    check("c", &module.c(), &[0.685871]);
}

#[test]
fn cross() {
    let module = Cross::new(DVec3::new(-1.198, -0.522, -1.985), DVec3::new(1.32, -1.382, -0.93)).unwrap();
    check("c", &module.c(), &[-2.2578099999999997, -3.73434, 2.3446759999999998]);
}

#[test]
fn dot() {
    let module = Dot::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031]), DVector::<f64>::from_column_slice(&[1.485, -0.555, 0.393, -1.763, -0.449])).unwrap();
    check("c", &module.c(), &[-1.9606379999999994]);
}

#[test]
fn inner() {
    let module = Inner::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031]), DVector::<f64>::from_column_slice(&[1.485, -0.555, 0.393, -1.763, -0.449]), DMatrix::<f64>::from_column_slice(5, 5, &[13.914, 1.72, -1.661, -4.641, 1.417, 1.72, 11.257, -3.451, 3.467, 6.046, -1.661, -3.451, 8.616, -1.985, -4.013, -4.641, 3.467, -1.985, 13.767, 4.423, 1.417, 6.046, -4.013, 4.423, 13.699])).unwrap();
    check("c", &module.c(), &[-18.932876606999997]);
}

#[test]
fn solve() {
    let module = Solve::new(DMatrix::<f64>::from_column_slice(5, 5, &[15.414, 1.72, -1.661, -4.641, 1.417, 1.72, 12.757, -3.451, 3.467, 6.046, -1.661, -3.451, 10.116, -1.985, -4.013, -4.641, 3.467, -1.985, 15.267, 4.423, 1.417, 6.046, -4.013, 4.423, 15.199]), DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("c", &module.c(), &[0.01819260039673947, 0.06060584121959225, -0.1644589395150443, 0.0007173603895149425, -0.06739577867310559]);
    check("d", &module.d(), &[0.01819260039673947, 0.06060584121959225, -0.1644589395150443, 0.0007173603895149425, -0.06739577867310559]);
    check("f", &module.f(), &[0.01819260039673947, 0.06060584121959225, -0.1644589395150443, 0.0007173603895149425, -0.06739577867310559]);
    check("g", &module.g(), &[0.01819260039673947, 0.06060584121959225, -0.1644589395150443, 0.0007173603895149425, -0.06739577867310559]);
}

#[test]
fn solve_matrix() {
    let module = SolveMatrix::new(DMat3::from_cols_array(&[6.747, 3.09, -0.541, 3.09, 6.465, 1.032, -0.541, 1.032, 5.479]), SMatrix::<f64, 3, 2>::from_column_slice(&[-0.708, 0.36, -0.239, -1.399, 0.42, -1.042])).unwrap();
    check("C", &module.C(), &[-0.1850059607899894, 0.1587622958091299, -0.09179246469472646, -0.35818615228944356, 0.2806041179493012, -0.27840156198435256]);
    check("D", &module.D(), &[-0.05596651053251429, 0.05656404061387701, -0.03293382675786417, -0.10953282794922074, 0.10886655280365573, -0.08213343756128011]);
}

#[test]
fn inverse() {
    let module = Inverse::new(DMat3::from_cols_array(&[6.747, 3.09, -0.541, 3.09, 6.465, 1.032, -0.541, 1.032, 5.479]), DMat3::from_cols_array(&[0.489, -1.359, -1.857, 1.956, 0.45, 0.06, -1.139, -1.824, -0.135])).unwrap();
    check("B", &module.B(), &[0.6222531243657277, -1.4096692236117303, -1.8403693569930253, 1.9053307763882696, 0.5894216541041503, 0.03709651062850259, -1.1223693569930253, -1.8469034893714975, 0.0030710761997805314]);
}

#[test]
fn matrix_power() {
    let module = MatrixPower::new(DMatrix::<f64>::from_column_slice(3, 3, &[0.5, -1.099, -1.979, 1.589, -0.799, 1.285, 1.103, 1.494, 1.188])).unwrap();
    check("B", &module.B(), &[33.13704129627625, 29.907882423988966, 54.03735196871301, -17.845363211014092, 0.9636283520386568, 15.84748744006126, -44.22171309969906, -3.2960504026166966, -13.869384052853448]);
    check("C", &module.C(), &[-3.679148, -2.628025, -4.7527669999999995, 0.9422439999999999, 0.8118799999999999, -2.6447659999999997, 4.23583, -0.631031, 1.1482969999999997]);
}

#[test]
fn matrix_root() {
    let module = MatrixRoot::new(DMatrix::<f64>::from_column_slice(4, 4, &[11.003, -3.665, 3.585, 3.262, -3.665, 7.469, -2.673, -1.743, 3.585, -2.673, 9.533, 4.463, 3.262, -1.743, 4.463, 8.6])).unwrap();
    check("B", &module.B(), &[0.3363696820584014, 0.06471530525657812, -0.03747579097006679, -0.04107245858732654, 0.06471530525657805, 0.4012962626375282, 0.04153360305585839, 0.009845538525812256, -0.037475790970066813, 0.041533603055858286, 0.37443695258283416, -0.0875081209474078, -0.04107245858732656, 0.009845538525812209, -0.08750812094740781, 0.38800806284236244]);
    check("C", &module.C(), &[3.195564947383687, -0.5776741852019612, 0.49233820123565036, 0.463961526861874, -0.5776741852019608, 2.631920097255542, -0.4007800643130853, -0.2183219582699734, 0.49233820123565036, -0.40078006431308466, 2.9335886935878803, 0.7239031789587648, 0.46396152686187403, -0.218321958269973, 0.7239031789587649, 2.795181463093686]);
}

#[test]
fn scalar_power() {
    let module = ScalarPower::new(1.5_f64, -0.75_f64).unwrap();
    check("c", &module.c(), &[1.8444698661672025]);
    check("d", &module.d(), &[1.3554030054147672]);
}

#[test]
fn determinant() {
    let module = Determinant::new(DMat3::from_cols_array(&[0.5, -1.099, -1.979, 1.589, -0.799, 1.285, 1.103, 1.494, 1.188]), DMatrix::<f64>::from_column_slice(5, 5, &[13.914, 1.72, -1.661, -4.641, 1.417, 1.72, 11.257, -3.451, 3.467, 6.046, -1.661, -3.451, 8.616, -1.985, -4.013, -4.641, 3.467, -1.985, 13.767, 4.423, 1.417, 6.046, -4.013, 4.423, 13.699])).unwrap();
    check("d", &module.d(), &[-7.359722154000001]);
    check("e", &module.e(), &[111961.3779007205]);
}

#[test]
fn vector_norms() {
    let module = VectorNorms::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("c", &module.c(), &[3.972763270067825]);
    check("d", &module.d(), &[3.3560000000000003]);
    check("f", &module.f(), &[1.634]);
    check("g", &module.g(), &[1.7593930803770677]);
    check("h", &module.h(), &[3.945712]);
    check("k", &module.k(), &[11.837136]);
    check("z", &module.z(), &[5.0]);
}

#[test]
fn matrix_norms() {
    let module = MatrixNorms::new(DMatrix::<f64>::from_column_slice(4, 5, &[-0.708, 0.36, -0.239, -1.14, -1.399, 0.42, -1.042, 0.687, 1.265, 0.552, -0.39, -0.798, -0.482, 0.706, -1.613, 1.496, 1.915, -1.397, 1.871, 0.649])).unwrap();
    check("c", &module.c(), &[4.846026516642269]);
    check("d", &module.d(), &[4.846026516642269]);
    check("f", &module.f(), &[7.927965619098011]);
}

#[test]
fn weighted_norm() {
    let module = WeightedNorm::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031]), DMatrix::<f64>::from_column_slice(5, 5, &[13.914, 1.72, -1.661, -4.641, 1.417, 1.72, 11.257, -3.451, 3.467, 6.046, -1.661, -3.451, 8.616, -1.985, -4.013, -4.641, 3.467, -1.985, 13.767, 4.423, 1.417, 6.046, -4.013, 4.423, 13.699]), 2.5_f64).unwrap();
    check("c", &module.c(), &[7.4999982992664735]);
    check("d", &module.d(), &[56.249974488999996]);
    check("f", &module.f(), &[1.8375759460255032]);
}

#[test]
fn absolute() {
    let module = Absolute::new(1.5_f64, -0.75_f64).unwrap();
    check("c", &module.c(), &[2.25]);
}

#[test]
fn callback() {
    let module = Callback::new(|x: f64| x * x + 1.0, 1.5_f64).unwrap();
    check("b", &module.b(), &[3.25]);
}

#[test]
fn callback_vectors() {
    let module = CallbackVectors::new(|x: f64, v: DVector<f64>| v * x, 1.5_f64, DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("b", &module.b(), &[0.8385, 1.4505, -2.4509999999999996, 0.2475, 0.0465]);
}

#[test]
fn callback_matrix() {
    let module = CallbackMatrix::new(|p: DMatrix<f64>| p.transpose(), DMatrix::<f64>::from_column_slice(4, 5, &[-0.708, 0.36, -0.239, -1.14, -1.399, 0.42, -1.042, 0.687, 1.265, 0.552, -0.39, -0.798, -0.482, 0.706, -1.613, 1.496, 1.915, -1.397, 1.871, 0.649])).unwrap();
    check("b", &module.b(), &[-0.708, -1.399, 1.265, -0.482, 1.915, 0.36, 0.42, 0.552, 0.706, -1.397, -0.239, -1.042, -0.39, -1.613, 1.871, -1.14, 0.687, -0.798, 1.496, 0.649]);
}

#[test]
fn callback_nothing() {
    let module = CallbackNothing::new(|| 2.5, || 3.5).unwrap();
    check("y", &module.y(), &[6.0]);
}

#[test]
fn callback_each() {
    let module = CallbackEach::new(|v: DVec3| v.x + 2.0 * v.z, vec![DVec3::new(-0.353, 1.691, -1.725), DVec3::new(-0.28, 0.078, 1.804), DVec3::new(-0.996, 1.224, 0.706), DVec3::new(0.868, 0.518, 1.886)]).unwrap();
    check("y", &module.y(), &[-3.803, 3.3280000000000003, 0.4159999999999999, 4.64]);
}

#[test]
fn callbacks() {
    let module = Callbacks::new([(|v: DVec3| v.x) as fn(DVec3) -> f64, |v: DVec3| v.y, |v: DVec3| v.z], DVec3::new(-1.198, -0.522, -1.985), vec![1.0_f64, 2.0_f64, 3.0_f64]).unwrap();
    check("b", &module.b(), &[-8.197000000000001]);
}

#[test]
fn callback_two_results() {
    let module = CallbackTwoResults::new(|x: f64| (x, x * x), 1.5_f64).unwrap();
    check("b", &module.b(), &[1.5]);
    check("c", &module.c(), &[2.25]);
}

#[test]
fn cases() {
    let module = Cases::new(1.5_f64).unwrap();
    check("y", &module.y(), &[1.0]);
}

#[test]
fn cases_and() {
    let module = CasesAnd::new(-1.0_f64, 1.5_f64, -0.75_f64).unwrap();
    check("y", &module.y(), &[-0.75]);
}

#[test]
fn cases_set() {
    let module = CasesSet::new(1.5_f64, 4_i64, Set::<i64>::from_iter([1_i64, 2_i64, 3_i64])).unwrap();
    check("y", &module.y(), &[3.0]);
}

#[test]
fn cases_entries() {
    let module = CasesEntries::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("y", &module.y(), &[0.559, 0.967, 0.0, 0.165, 0.031]);
}

#[test]
fn cases_matrix() {
    let module = CasesMatrix::new(DMatrix::<f64>::from_column_slice(4, 4, &[11.003, -3.665, 3.585, 3.262, -3.665, 7.469, -2.673, -1.743, 3.585, -2.673, 9.533, 4.463, 3.262, -1.743, 4.463, 8.6])).unwrap();
    check("A", &module.A(), &[1.0, -3.665, 3.585, 3.262, -3.665, 1.0, -2.673, -1.743, 3.585, -2.673, 1.0, 4.463, 3.262, -1.743, 4.463, 1.0]);
}

#[test]
fn local_function() {
    let module = LocalFunction::new(1.5_f64).unwrap();
    check("y", &module.y(), &[8.25]);
}

#[test]
fn local_function_two() {
    let module = LocalFunctionTwo::new(1.5_f64).unwrap();
    check("z", &module.z(), &[4.5]);
}

#[test]
fn local_function_affine() {
    let module = LocalFunctionAffine::new(DMatrix::<f64>::from_column_slice(5, 5, &[13.914, 1.72, -1.661, -4.641, 1.417, 1.72, 11.257, -3.451, 3.467, 6.046, -1.661, -3.451, 8.616, -1.985, -4.013, -4.641, 3.467, -1.985, 13.767, 4.423, 1.417, 6.046, -4.013, 4.423, 13.699]), DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031]), DVector::<f64>::from_column_slice(&[1.485, -0.555, 0.393, -1.763, -0.449])).unwrap();
    check("y", &module.y(), &[27.159767000000002, -12.909652999999999, 6.5022, -35.688323, -16.745994]);
}

#[test]
fn local_function_any_size() {
    let module = LocalFunctionAnySize::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031]), DVector::<f64>::from_column_slice(&[1.485, -0.555, 0.393, -1.763, -0.449]), DVec3::new(-1.198, -0.522, -1.985)).unwrap();
    check("y", &module.y(), &[-0.6535459999999998]);
    check("z", &module.z(), &[5.647913]);
}

#[test]
fn sphere() {
    let module = Sphere::new(0.4_f64, 0.7_f64, 2.0_f64).unwrap();
    check("x_θ_ϕ", &module.x_θ_ϕ(), &[1.4089326105511835, 1.1867275667227748, 0.778836684617301]);
}

#[test]
fn closest_point() {
    let module = ClosestPoint::new(vec![DVec3::new(-1.148, 1.662, 1.361), DVec3::new(-1.55, 0.415, -0.083), DVec3::new(0.379, 0.637, -0.773), DVec3::new(1.845, -0.137, 0.512)], vec![DVec3::new(-0.14459789126118103, 0.6926771504891137, -0.7066044261346666), DVec3::new(-0.15323441873667648, 0.04268673093378844, 0.9872674692891584), DVec3::new(-0.5761338706278405, 0.7080199373980691, 0.4083840488586902), DVec3::new(0.40564538919124815, 0.24207870000122875, 0.8813907880353617)]).unwrap();
    check("q", &module.q(), &[-0.35515047173865294, 0.7611212205441708, 0.0751606382321983]);
    check("P", &module.P(), &[0.9790914498428197, 0.10015965528552959, -0.10217350997488975, 0.10015965528552959, 0.5201983651902817, 0.4894487404179563, -0.10217350997488975, 0.4894487404179563, 0.5007101849668985, 0.9765192129144329, 0.006541076402407979, 0.15128335679415375, 0.006541076402407979, 0.9981778430021864, -0.042143220821228546, 0.15128335679415375, -0.042143220821228546, 0.02530294408338085, 0.6680697631153827, 0.4079142670148309, 0.2352838827716263, 0.4079142670148309, 0.49870776824683427, -0.2891440487072998, 0.2352838827716263, -0.2891440487072998, 0.8332224686377829, 0.8354518182278808, -0.09819810847690984, -0.3575321092421852, -0.09819810847690984, 0.9413979030057151, -0.2133659361606589, -0.3575321092421852, -0.2133659361606589, 0.22315027876640403]);
}

#[test]
fn kernel() {
    let module = Kernel::new(1.5_f64, 2.25_f64, DVec2::new(0.541, -1.264), DVec2::new(-1.753, -0.354)).unwrap();
    check("Omega", &module.Omega(), &[7.3532917499999995, 0.3705284999999999, 0.37052849999999965, 2.678505]);
}

#[test]
fn mutual_information() {
    let module = MutualInformation::new(DVector::<f64>::from_column_slice(&[1.056, 1.261, 0.92, 1.547]), DMatrix::<f64>::from_column_slice(5, 4, &[1.653, 1.663, 0.989, 1.844, 1.916, 1.208, 1.813, 1.006, 0.362, 0.758, 1.511, 1.879, 1.25, 1.336, 1.753, 0.093, 1.919, 0.268, 0.711, 0.154])).unwrap();
    check("I_X_Y", &module.I_X_Y(), &[-54.96711895172478]);
}

#[test]
fn demosaic() {
    let module = Demosaic::new(DMatrix::<f64>::from_column_slice(4, 5, &[-0.708, 0.36, -0.239, -1.14, -1.399, 0.42, -1.042, 0.687, 1.265, 0.552, -0.39, -0.798, -0.482, 0.706, -1.613, 1.496, 1.915, -1.397, 1.871, 0.649]), DMatrix::<f64>::from_column_slice(4, 5, &[1.474, 1.418, 1.536, 1.042, 1.38, 1.23, 0.566, 1.848, 1.78, 1.712, 0.279, 1.505, 1.616, 0.209, 0.495, 0.129, 0.279, 1.278, 0.356, 0.191]), DVector::<f64>::from_column_slice(&[1.246, 0.632, 0.443, 1.235])).unwrap();
    check("C_x_y", &module.C_x_y(), &[-0.13179924390781791]);
}

#[test]
fn divergence() {
    let module = Divergence::new(DMatrix::<f64>::from_column_slice(4, 4, &[11.003, -3.665, 3.585, 3.262, -3.665, 7.469, -2.673, -1.743, 3.585, -2.673, 9.533, 4.463, 3.262, -1.743, 4.463, 8.6]), DMatrix::<f64>::from_column_slice(4, 4, &[23.006, -7.33, 7.17, 6.524, -7.33, 15.938, -5.346, -3.486, 7.17, -5.346, 20.066, 8.926, 6.524, -3.486, 8.926, 18.2])).unwrap();
    check("D_KL", &module.D_KL(), &[0.4609125144154862]);
}

#[test]
fn block_product() {
    let module = BlockProduct::new(vec![DMatrix::<f64>::from_column_slice(2, 2, &[1.469, -1.354, 1.572, -1.893]), DMatrix::<f64>::from_column_slice(2, 2, &[0.603, 0.255, -1.141, 1.779]), DMatrix::<f64>::from_column_slice(2, 2, &[-0.483, -0.174, -0.989, 0.629])], DMatrix::<f64>::from_column_slice(2, 2, &[3.451, -1.483, 1.189, 3.067]), DMatrix::<f64>::from_column_slice(2, 2, &[3.5300000000000002, 0.295, -1.211, 2.555]), DMatrix::<f64>::from_column_slice(2, 2, &[0.45100000000000007, 1.19, 0.506, 1.255]), DMatrix::<f64>::from_column_slice(2, 2, &[2.437, 0.645, -1.615, 2.528]), DMatrix::<f64>::from_column_slice(2, 2, &[3.416, -0.645, -1.797, 1.272]), DMatrix::<f64>::from_column_slice(2, 2, &[3.2960000000000003, -0.691, 1.214, 2.888])).unwrap();
    check("ret", &module.ret(), &[3.881807513937, -4.388283263187, 2.4309580502086208, -1.1680059435382621, -9.826476211339001, 11.134961520268998, -13.658180358916422, 8.186828091092998, 23.338010421000078, -25.16666321700013, -326.56435616765475, 235.4533959767008, -9.723055668999999, 10.710044897000003, 81.18417390624597, -58.28217945091108]);
}

#[test]
fn vertex_normal() {
    let module = VertexNormal::new(vec![DVec3::new(-0.353, 1.691, -1.725), DVec3::new(-0.28, 0.078, 1.804), DVec3::new(-0.996, 1.224, 0.706), DVec3::new(0.868, 0.518, 1.886)], vec![-1.596_f64, -0.478_f64, -1.465_f64, 0.65_f64], Set::<i64>::from_iter([1_i64, 3_i64, 4_i64]), |v: DVec3| v * 2.0).unwrap();
    check("n_v", &module.n_v(), &[0.45284452830521227, -0.7274452733679517, 0.5155145074958177]);
}

#[test]
fn quasi_monte_carlo() {
    let module = QuasiMonteCarlo::new(DVector::<f64>::from_column_slice(&[-1.69, 1.053, -1.476]), vec![|x: f64| x; 3], DMatrix::<f64>::from_column_slice(3, 4, &[1.322, -1.14, -1.674, -0.493, -1.01, 1.011, -0.513, -0.681, 0.316, 0.158, -0.17, -0.801]), 4.0_f64, |x: f64| x * x, |x: f64| x + 5.0).unwrap();
    check("ret", &module.ret(), &[-2.171606995540455]);
}

#[test]
fn view_plane() {
    let module = ViewPlane::new(DVec3::new(-1.467, -1.477, -1.675), DVec3::new(1.626, -0.923, -0.774), DVec3::new(1.331, 0.48, -1.251), DVec3::new(-0.261, 1.536, -0.499), DVec3::new(0.844, -1.613, 0.909), 1.5_f64, -0.75_f64, |t: f64, v: f64| DVec3::new(t, v, 1.0), |t: f64, v: f64| t + v).unwrap();
    check("x_θ_v", &module.x_θ_v(), &[-0.877404615626818]);
}

#[test]
fn conformal() {
    let module = Conformal::new(vec![DVec3::new(-0.42, 0.565, -1.262), DVec3::new(1.038, 1.031, 0.885), DVec3::new(-0.221, -0.487, -0.321)], vec![DVec3::new(-1.867, 1.377, 0.169), DVec3::new(-0.45, 0.192, 0.887), DVec3::new(-0.474, 1.323, 1.678)], vec![SMatrix::<f64, 2, 3>::from_column_slice(&[-0.517, 1.03, -1.743, -1.237, 0.075, -0.935]), SMatrix::<f64, 2, 3>::from_column_slice(&[0.144, -1.497, 0.993, -1.263, 1.586, 1.198]), SMatrix::<f64, 2, 3>::from_column_slice(&[0.578, 1.757, 0.884, 1.372, 1.987, 1.108])], vec![0.45_f64, 1.449_f64, 1.041_f64]).unwrap();
    check("E_LSCM", &module.E_LSCM(), &[86.70695506039033]);
}

#[test]
fn diagonal() {
    let module = Diagonal::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("D", &module.D(), &[0.559, 0.0, 0.0, 0.0, 0.0, 0.0, 0.967, 0.0, 0.0, 0.0, 0.0, 0.0, -1.634, 0.0, 0.0, 0.0, 0.0, 0.0, 0.165, 0.0, 0.0, 0.0, 0.0, 0.0, 0.031]);
    check("y", &module.y(), &[0.31248100000000006, 0.935089, 2.6699559999999996, 0.027225000000000003, 0.0009609999999999999]);
}

#[test]
fn slices() {
    let module = Slices::new(DMatrix::<f64>::from_column_slice(4, 5, &[-0.708, 0.36, -0.239, -1.14, -1.399, 0.42, -1.042, 0.687, 1.265, 0.552, -0.39, -0.798, -0.482, 0.706, -1.613, 1.496, 1.915, -1.397, 1.871, 0.649])).unwrap();
    check("b", &module.b(), &[-0.708, -1.399, 1.265, -0.482, 1.915]);
    check("c", &module.c(), &[-1.399, 0.42, -1.042, 0.687]);
    check("d", &module.d(), &[0.552]);
}

#[test]
fn nested_index() {
    let module = NestedIndex::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031]), vec![2_i64, 5_i64, 2_i64]).unwrap();
    check("b", &module.b(), &[1.9649999999999999]);
}

#[test]
fn trigonometric() {
    let module = Trigonometric::new(0.35_f64).unwrap();
    check("b", &module.b(), &[3.5547701613148788]);
    check("c", &module.c(), &[3.6629142391112133]);
    check("d", &module.d(), &[3.045330823836999]);
    check("f", &module.f(), &[9.39831816326863]);
}

#[test]
fn trigonometric_entries() {
    let module = TrigonometricEntries::new(DMatrix::<f64>::from_column_slice(4, 5, &[-0.708, 0.36, -0.239, -1.14, -1.399, 0.42, -1.042, 0.687, 1.265, 0.552, -0.39, -0.798, -0.482, 0.706, -1.613, 1.496, 1.915, -1.397, 1.871, 0.649]), 1.5_f64).unwrap();
    check("b", &module.b(), &[-0.6503157446135971, 0.35227423327508994, -0.2367311697628689, -0.9086334961158832, -0.9852792701490639, 0.40776045305957015, -0.8634149422749642, 0.6342205832324105, 0.9536075186567536, 0.5243912314639697, -0.3801884151231614, -0.715961243698067, -0.46355224064633854, 0.6487951169435462, -0.9991095571634604, 0.9972040586026603, 0.9413444692690194, -0.9849353948041522, 0.9552762797633546, 0.6043900194769934]);
    check("c", &module.c(), &[1.9899924966004454]);
}

#[test]
fn exponentials() {
    let module = Exponentials::new(1.5_f64).unwrap();
    check("b", &module.b(), &[16.477181388766216]);
}

#[test]
fn linear_algebra_functions() {
    let module = LinearAlgebraFunctions::new(DMatrix::<f64>::from_column_slice(4, 4, &[11.003, -3.665, 3.585, 3.262, -3.665, 7.469, -2.673, -1.743, 3.585, -2.673, 9.533, 4.463, 3.262, -1.743, 4.463, 8.6])).unwrap();
    check("a", &module.a(), &[36.605000000000004]);
    check("b", &module.b(), &[36.605000000000004]);
    check("c", &module.c(), &[11.003, 7.469, 9.533, 8.6]);
    check("d", &module.d(), &[11.003, -3.665, 3.585, 3.262, -3.665, 7.469, -2.673, -1.743, 3.585, -2.673, 9.533, 4.463, 3.262, -1.743, 4.463, 8.6]);
    check("f", &module.f(), &[3444.040409997413]);
    check("g", &module.g(), &[4.0]);
    check("h", &module.h(), &[0.12042401550576207, 0.045777391688652753, -0.020356007386119084, -0.025835381849095885, 0.04577739168865276, 0.16704873595296507, 0.028932173609738442, 0.0014785818903918812, -0.020356007386119084, 0.02893217360973844, 0.15099017778289953, -0.06477198706392862, -0.02583538184909589, 0.001478581890391882, -0.06477198706392862, 0.1599918095456997]);
}

#[test]
fn diagonal_of_vector() {
    let module = DiagonalOfVector::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("D", &module.D(), &[0.559, 0.0, 0.0, 0.0, 0.0, 0.0, 0.967, 0.0, 0.0, 0.0, 0.0, 0.0, -1.634, 0.0, 0.0, 0.0, 0.0, 0.0, 0.165, 0.0, 0.0, 0.0, 0.0, 0.0, 0.031]);
}

#[test]
fn chain() {
    let module = Chain::new(-0.75_f64).unwrap();
    check("d", &module.d(), &[-0.046875]);
}

#[test]
fn bare() {
    let module = Bare::new(1.5_f64, -0.75_f64).unwrap();
    check("ret", &module.ret(), &[0.75]);
}

#[test]
fn greek() {
    let module = Greek::new(1.5_f64, -0.75_f64, 2.25_f64).unwrap();
    check("theta", &module.theta(), &[1.125]);
}

#[test]
fn integers() {
    let module = Integers::new(3_i64, 4_i64).unwrap();
    check("c", &module.c(), &[14.0]);
    check("d", &module.d(), &[0.75]);
}

#[test]
fn integer_vectors() {
    let module = IntegerVectors::new(DVector::<i64>::from_column_slice(&[1, 2, 3]), DVector::<i64>::from_column_slice(&[4, 5, 6])).unwrap();
    check("c", &module.c(), &[5.0, 7.0, 9.0]);
}

#[test]
fn integer_matrices() {
    let module = IntegerMatrices::new(SMatrix::<i64, 2, 3>::from_column_slice(&[1, 4, 2, 5, 3, 6]), SMatrix::<i64, 3, 2>::from_column_slice(&[1, 2, 0, 0, 1, 3])).unwrap();
    check("C", &module.C(), &[5.0, 14.0, 11.0, 23.0]);
}

#[test]
fn sequence_definition() {
    let module = SequenceDefinition::new(DMat3::from_cols_array(&[0.5, -1.099, -1.979, 1.589, -0.799, 1.285, 1.103, 1.494, 1.188]), vec![DVec3::new(-0.353, 1.691, -1.725), DVec3::new(-0.28, 0.078, 1.804), DVec3::new(-0.996, 1.224, 0.706), DVec3::new(0.868, 0.518, 1.886)]).unwrap();
    check("y", &module.y(), &[0.6078240000000001, -3.540312, 0.8222219999999997, 1.973754, 2.9405740000000002, 2.797502, 2.225654, 1.1713919999999998, 4.382652, 3.33736, 1.4498699999999998, 1.1884259999999995]);
}

#[test]
fn sequence_of_matrices() {
    let module = SequenceOfMatrices::new(vec![SMatrix::<f64, 2, 3>::from_column_slice(&[-0.517, 1.03, -1.743, -1.237, 0.075, -0.935]), SMatrix::<f64, 2, 3>::from_column_slice(&[0.144, -1.497, 0.993, -1.263, 1.586, 1.198]), SMatrix::<f64, 2, 3>::from_column_slice(&[0.578, 1.757, 0.884, 1.372, 1.987, 1.108])]).unwrap();
    check("B", &module.B(), &[3.3109630000000005, 1.5534560000000002, 1.5534560000000002, 3.465294, 3.5221810000000002, 0.430301, 0.430301, 5.271382, 5.063709, 4.42999, 4.42999, 6.197096999999999]);
}

#[test]
fn size_of() {
    let module = SizeOf::new(DVec3::new(-1.198, -0.522, -1.985), SMatrix::<f64, 2, 4>::from_column_slice(&[-0.708, 0.36, -1.399, 0.42, 1.265, 0.552, -0.482, 0.706])).unwrap();
    check("n", &module.n(), &[3.0]);
    check("m", &module.m(), &[2.0]);
    check("k", &module.k(), &[4.0]);
}

#[test]
fn set_sum() {
    let module = SetSum::new(Set::<i64>::from_iter([1_i64, 5_i64, 7_i64])).unwrap();
    check("b", &module.b(), &[13.0]);
    check("c", &module.c(), &[3.0]);
}

#[test]
fn pair_sum() {
    let module = PairSum::new(Set::<(i64, i64)>::from_iter([(1_i64, 2_i64), (3_i64, 4_i64)])).unwrap();
    check("b", &module.b(), &[14.0]);
}

#[test]
fn pair_entries() {
    let module = PairEntries::new(Set::<(i64, i64)>::from_iter([(1_i64, 2_i64), (3_i64, 4_i64)]), DMatrix::<f64>::from_column_slice(4, 4, &[11.003, -3.665, 3.585, 3.262, -3.665, 7.469, -2.673, -1.743, 3.585, -2.673, 9.533, 4.463, 3.262, -1.743, 4.463, 8.6])).unwrap();
    check("b", &module.b(), &[0.798]);
}

#[test]
fn set_filter() {
    let module = SetFilter::new(Set::<i64>::from_iter([1_i64, 3_i64]), DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("b", &module.b(), &[-1.0749999999999997]);
}

#[test]
fn pair_filter() {
    let module = PairFilter::new(Set::<(i64, i64)>::from_iter([(1_i64, 2_i64), (3_i64, 4_i64)]), DMatrix::<f64>::from_column_slice(4, 4, &[11.003, -3.665, 3.585, 3.262, -3.665, 7.469, -2.673, -1.743, 3.585, -2.673, 9.533, 4.463, 3.262, -1.743, 4.463, 8.6])).unwrap();
    check("b", &module.b(), &[0.798]);
}

#[test]
fn ones() {
    let module = Ones::new(DVec3::new(-1.198, -0.522, -1.985), 2_i64, 3_i64).unwrap();
    check("y", &module.y(), &[-3.705]);
    check("z", &module.z(), &[1.0, 1.0]);
    check("k", &module.k(), &[0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
}

#[test]
fn vector_literal() {
    let module = VectorLiteral::new(1.5_f64, -0.75_f64, DVec3::new(-1.198, -0.522, -1.985)).unwrap();
    check("y", &module.y(), &[1.5, 2.0, -0.75]);
    check("z", &module.z(), &[-1.198, -0.522, -1.985, 1.5]);
}

#[test]
fn precedence() {
    let module = Precedence::new(1.5_f64, -0.75_f64, 2.25_f64).unwrap();
    check("y", &module.y(), &[3.0]);
    check("z", &module.z(), &[-1.5]);
}

#[test]
fn ascii() {
    let module = Ascii::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("y", &module.y(), &[5.932093635033913]);
}

#[test]
fn integral() {
    let module = Integral::new().unwrap();
    check("y", &module.y(), &[0.3333333333333333]);
}

#[test]
fn integral_bounds() {
    let module = IntegralBounds::new(1.5_f64).unwrap();
    check("y", &module.y(), &[0.5]);
}

#[test]
fn mean_normal_curvature() {
    let module = MeanNormalCurvature::new(DVec3::new(-1.198, -0.522, -1.985), |t: f64, p: DVec3| t.cos().powi(2) * p.x + t.sin().powi(2) * p.y).unwrap();
    check("H_p", &module.H_p(), &[-0.86]);
}

#[test]
fn argmin() {
    let module = Argmin::new(1.5_f64).unwrap();
    check("y", &module.y(), &[1.5]);
}

#[test]
fn rigid() {
    let module = Rigid::new(vec![DVec3::new(-0.353, 1.691, -1.725), DVec3::new(-0.28, 0.078, 1.804), DVec3::new(-0.996, 1.224, 0.706), DVec3::new(0.868, 0.518, 1.886)], vec![DMat3::from_cols_array(&[1.972, 1.301, -1.633, -1.408, 1.682, 1.951, 0.851, -1.506, -1.533]), DMat3::from_cols_array(&[-1.293, 1.002, -1.131, 0.3, -1.238, 1.076, -0.215, 1.658, -1.73]), DMat3::from_cols_array(&[-0.106, -0.751, -1.773, -1.87, 0.879, 1.981, -0.745, -0.18, 1.555]), DMat3::from_cols_array(&[1.665, -1.091, 0.013, -1.014, -1.5, -1.507, -0.424, -1.868, -1.295])]).unwrap();
    check("ret", &module.ret(), &[13.131657469547504]);
}

#[test]
fn rigid_argument() {
    let module = RigidArgument::new(vec![DVec3::new(-0.353, 1.691, -1.725), DVec3::new(-0.28, 0.078, 1.804), DVec3::new(-0.996, 1.224, 0.706), DVec3::new(0.868, 0.518, 1.886)], vec![DMat3::from_cols_array(&[1.972, 1.301, -1.633, -1.408, 1.682, 1.951, 0.851, -1.506, -1.533]), DMat3::from_cols_array(&[-1.293, 1.002, -1.131, 0.3, -1.238, 1.076, -0.215, 1.658, -1.73]), DMat3::from_cols_array(&[-0.106, -0.751, -1.773, -1.87, 0.879, 1.981, -0.745, -0.18, 1.555]), DMat3::from_cols_array(&[1.665, -1.091, 0.013, -1.014, -1.5, -1.507, -0.424, -1.868, -1.295])]).unwrap();
    check("C", &module.C(), &[-0.30094175702969866, 0.02849933837988866, 0.37429130208386435]);
}

#[test]
fn least_squares() {
    let module = LeastSquares::new(DMatrix::<f64>::from_column_slice(5, 4, &[-0.708, -1.399, 1.265, -0.482, 1.915, 0.36, 0.42, 0.552, 0.706, -1.397, -0.239, -1.042, -0.39, -1.613, 1.871, -1.14, 0.687, -0.798, 1.496, 0.649]), DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("x̂", &module.x̂(), &[-0.3965796865097306, -7.14285445724729, -4.403790034043785, -1.473387692820929]);
}

#[test]
fn laplacian() {
    let module = Laplacian::new(DMatrix::<f64>::from_column_slice(4, 4, &[11.003, 3.665, 3.585, 3.262, 3.665, 7.469, 2.673, 1.743, 3.585, 2.673, 9.533, 4.463, 3.262, 1.743, 4.463, 8.6]), Set::<(i64, i64)>::from_iter([(0_i64, 1_i64), (1_i64, 2_i64), (0_i64, 3_i64), (1_i64, 0_i64)]), 4_i64).unwrap();
    check("L", &module.L(), &[-6.927, 3.665, 0.0, 0.0, 3.665, -6.338, 0.0, 0.0, 0.0, 2.673, 0.0, 0.0, 3.262, 0.0, 0.0, 0.0]);
}

#[test]
fn sparse_pairs() {
    let module = SparsePairs::new(Set::<(i64, i64)>::from_iter([(1_i64, 2_i64), (2_i64, 3_i64), (3_i64, 1_i64)]), 4_i64, vec![1.442_f64, -0.063_f64, -1.265_f64, 0.679_f64]).unwrap();
    check("K", &module.K(), &[-1.379, 0.0, 0.17700000000000005, 0.0, 1.379, 1.3279999999999998, 0.0, 0.0, 0.0, -1.3279999999999998, -0.17700000000000005, 0.0, 0.0, 0.0, 0.0, 0.0]);
}

#[test]
fn sparse_ones() {
    let module = SparseOnes::new(Set::<(i64, i64)>::from_iter([(1_i64, 2_i64), (3_i64, 3_i64)])).unwrap();
    check("A", &module.A(), &[0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
}

#[test]
fn ragged() {
    let module = Ragged::new(vec![DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031]), DVector::<f64>::from_column_slice(&[-1.198, -0.522, -1.985])]).unwrap();
    check("b", &module.b(), &[4.362915455538052]);
}

#[test]
fn expression_sizes() {
    let module = ExpressionSizes::new(DMatrix::<f64>::from_column_slice(4, 3, &[-0.708, -1.399, 1.265, -0.482, 0.36, 0.42, 0.552, 0.706, -0.239, -1.042, -0.39, -1.613]), DVector::<f64>::from_column_slice(&[-1.198, -0.522, -1.985])).unwrap();
    check("y", &module.y(), &[1.134679, 3.525132, -1.0294639999999997, 3.410709]);
}

#[test]
fn tuples() {
    let module = Tuples::new(1.5_f64, -0.75_f64).unwrap();
    check("u", &module.u(), &[1.5]);
    check("v", &module.v(), &[-0.75]);
}

#[test]
fn sequence_subscripts() {
    let module = SequenceSubscripts::new(DVec3::new(-1.198, -0.522, -1.985), DMat2::from_cols_array(&[1.669, 0.056, 0.517, -0.013]), vec![DMat2::from_cols_array(&[1.669, 0.056, 0.517, -0.013]), DMat2::from_cols_array(&[-1.01, -1.23, -1.953, 0.768])]).unwrap();
    check("y", &module.y(), &[-1.72]);
    check("z", &module.z(), &[0.517]);
    check("w", &module.w(), &[1.669, 0.056, 0.517, -0.013]);
    check("v", &module.v(), &[-1.23]);
}

#[test]
fn sum_entries_of_matrices() {
    let module = SumEntriesOfMatrices::new(vec![DMat2::from_cols_array(&[1.669, 0.056, 0.517, -0.013]), DMat2::from_cols_array(&[-1.01, -1.23, -1.953, 0.768])]).unwrap();
    check("s", &module.s(), &[-1.436]);
}

#[test]
fn quotient_of_sums() {
    let module = QuotientOfSums::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031]), DVector::<f64>::from_column_slice(&[1.485, -0.555, 0.393, -1.763, -0.449])).unwrap();
    check("y", &module.y(), &[-0.098987626546682]);
}

#[test]
fn quadratic_form() {
    let module = QuadraticForm::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031]), DVector::<f64>::from_column_slice(&[1.485, -0.555, 0.393, -1.763, -0.449]), DMatrix::<f64>::from_column_slice(5, 5, &[13.914, 1.72, -1.661, -4.641, 1.417, 1.72, 11.257, -3.451, 3.467, 6.046, -1.661, -3.451, 8.616, -1.985, -4.013, -4.641, 3.467, -1.985, 13.767, 4.423, 1.417, 6.046, -4.013, 4.423, 13.699])).unwrap();
    check("y", &module.y(), &[-18.279330607]);
    check("B", &module.B(), &[0.8301150000000002, 1.4359950000000001, -2.42649, 0.24502500000000002, 0.046035, -0.31024500000000005, -0.5366850000000001, 0.9068700000000001, -0.09157500000000002, -0.017205, 0.21968700000000002, 0.380031, -0.642162, 0.064845, 0.012183000000000001, -0.9855170000000001, -1.704821, 2.8807419999999997, -0.290895, -0.05465299999999999, -0.250991, -0.434183, 0.7336659999999999, -0.07408500000000001, -0.013919]);
}

#[test]
fn pseudo_inverse() {
    let module = PseudoInverse::new(DMatrix::<f64>::from_column_slice(5, 4, &[-0.708, -1.399, 1.265, -0.482, 1.915, 0.36, 0.42, 0.552, 0.706, -1.397, -0.239, -1.042, -0.39, -1.613, 1.871, -1.14, 0.687, -0.798, 1.496, 0.649]), DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("y", &module.y(), &[-0.39657968650973024, -7.142854457247286, -4.403790034043786, -1.473387692820927]);
    check("P", &module.P(), &[0.42766753211930575, -7.934201526748252, -5.578007265339185, -2.2821648332409357, 0.2436947296165675, -6.064190789944931, -4.264335344871321, -1.4475729972826243, 0.5719628701271026, -2.223782581200451, -1.9686707046208347, -0.7832541216247428, 0.28004641709939515, -1.7042096344316018, -1.4970214332724303, -0.2013379905680072, 0.5510009826658853, -6.323530900599571, -4.253906099648602, -1.434546095421124]);
}

#[test]
fn sparse_algebra() {
    let module = SparseAlgebra::new(sparse(4, 4, &[(0, 0, 1.0), (0, 2, 5.0), (1, 1, 2.0), (2, 2, 3.0), (3, 1, -1.0), (3, 3, 4.0)]), DVector::<f64>::from_column_slice(&[-1.596, -0.478, -1.465, 0.65])).unwrap();
    check("y", &module.y(), &[-8.921, -0.956, -4.3950000000000005, 3.0780000000000003]);
    check("B", &module.B(), &[26.0, 0.0, 15.0, 0.0, 0.0, 4.0, 0.0, -2.0, 15.0, 0.0, 9.0, 0.0, 0.0, -2.0, 0.0, 17.0]);
    check("C", &module.C(), &[2.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, -4.0, -10.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -4.0]);
    check("D", &module.D(), &[1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, -1.0, 0.0, 0.0, 0.0, -0.0, 5.0, 0.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, 0.0, 2.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 5.0, 0.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 4.0]);
    check("z", &module.z(), &[0.8456666666666666, -0.239, -0.48833333333333334, 0.10275000000000001]);
}

#[test]
fn words() {
    let module = Words::new(1.5_f64, DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("y", &module.y(), &[2.059]);
}

#[test]
fn least_and_greatest() {
    let module = LeastAndGreatest::new(1.5_f64, -0.75_f64, Set::<f64>::from_iter([1.5, -2.0]), DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("y", &module.y(), &[2.25]);
    check("z", &module.z(), &[-1.033]);
}

#[test]
fn set_literal() {
    let module = SetLiteral::new(2_i64).unwrap();
    check("y", &module.y(), &[2.0]);
    check("S", &module.S(), &[1.0, 2.0]);
}

#[test]
fn fractions() {
    let module = Fractions::new(1.5_f64).unwrap();
    check("y", &module.y(), &[2.5]);
}

#[test]
fn bars() {
    let module = Bars::new(1.5_f64, -0.75_f64, 2.25_f64, DVec3::new(-1.198, -0.522, -1.985), DVec3::new(1.32, -1.382, -0.93)).unwrap();
    check("y", &module.y(), &[3.644778425332013]);
}

#[test]
fn mixed_program() {
    let module = MixedProgram::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031]), DVector::<f64>::from_column_slice(&[1.485, -0.555, 0.393, -1.763, -0.449]), Set::<i64>::from_iter([1_i64, 3_i64, 4_i64])).unwrap();
    check("y", &module.y(), &[2.7024540000000004]);
    check("t", &module.t(), &[2.7024540000000004]);
    check("z", &module.z(), &[8.303257622116002]);
    check("u", &module.u(), &[-0.10294199999999987]);
    check("v", &module.v(), &[3.0]);
    check("odd", &module.odd(), &[4.0, 5.0]);
    check("Q", &module.Q(), &[5.0]);
}

#[test]
fn single_entries() {
    let module = SingleEntries::new(1.5_f64, -0.75_f64).unwrap();
    check("y", &module.y(), &[1.5, -0.75, 0.0]);
}

#[test]
fn add_to() {
    let module = AddTo::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("y", &module.y(), &[1.677, 2.901, -4.901999999999999, 0.495, 0.093]);
}

#[test]
fn entries_of_row() {
    let module = EntriesOfRow::new(vec![DVec3::new(-0.353, 1.691, -1.725), DVec3::new(-0.28, 0.078, 1.804), DVec3::new(-0.996, 1.224, 0.706), DVec3::new(0.868, 0.518, 1.886)]).unwrap();
    check("P", &module.P(), &[-0.353, -0.28, -0.996, 0.868, 1.691, 0.078, 1.224, 0.518, -1.725, 1.804, 0.706, 1.886]);
}

#[test]
fn entries_of_column() {
    let module = EntriesOfColumn::new(vec![DVec3::new(-0.353, 1.691, -1.725), DVec3::new(-0.28, 0.078, 1.804), DVec3::new(-0.996, 1.224, 0.706), DVec3::new(0.868, 0.518, 1.886)]).unwrap();
    check("P", &module.P(), &[-0.353, 1.691, -1.725, -0.28, 0.078, 1.804, -0.996, 1.224, 0.706, 0.868, 0.518, 1.886]);
}

#[test]
fn triple_sum() {
    let module = TripleSum::new(DMat3::from_cols_array(&[0.5, -1.099, -1.979, 1.589, -0.799, 1.285, 1.103, 1.494, 1.188]), DMat3::from_cols_array(&[-0.128, -0.981, 0.214, -0.788, -0.22, 1.982, -0.886, 0.018, 1.171]), DMat3::from_cols_array(&[0.489, -1.359, -1.857, 1.956, 0.45, 0.06, -1.139, -1.824, -0.135])).unwrap();
    check("y", &module.y(), &[-6.063599513000001]);
}

#[test]
fn constrained() {
    let module = Constrained::new().unwrap();
    check("y", &module.y(), &[1.0]);
}

#[test]
fn simplex() {
    let module = Simplex::new(DMatrix::<f64>::from_column_slice(4, 4, &[11.003, -3.665, 3.585, 3.262, -3.665, 7.469, -2.673, -1.743, 3.585, -2.673, 9.533, 4.463, 3.262, -1.743, 4.463, 8.6]), DVector::<f64>::from_column_slice(&[-1.596, -0.478, -1.465, 0.65])).unwrap();
    check("y", &module.y(), &[0.27847869315768986, 0.46233934243352903, 0.25918196440878094, 4.5407318719934905e-18]);
}

#[test]
fn unit_vectors() {
    let module = UnitVectors::new(DVec3::new(-1.198, -0.522, -1.985), DVec3::new(1.32, -1.382, -0.93)).unwrap();
    check("y", &module.y(), &[-0.4470000581815356, -0.7393227053071941, 0.46419774401603775]);
}

#[test]
fn product_of_sequence() {
    let module = ProductOfSequence::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("y", &module.y(), &[-0.004517893324230001]);
    check("z", &module.z(), &[24.0]);
}

#[test]
fn factorial() {
    let module = Factorial::new().unwrap();
    check("y", &module.y(), &[120.0]);
}

#[test]
fn overloads() {
    let module = Overloads::new(1.5_f64, DVec3::new(-1.198, -0.522, -1.985)).unwrap();
    check("y", &module.y(), &[4.6265338205041395]);
}

#[test]
fn ranges() {
    let module = Ranges::new(DMatrix::<f64>::from_column_slice(5, 5, &[13.914, 1.72, -1.661, -4.641, 1.417, 1.72, 11.257, -3.451, 3.467, 6.046, -1.661, -3.451, 8.616, -1.985, -4.013, -4.641, 3.467, -1.985, 13.767, 4.423, 1.417, 6.046, -4.013, 4.423, 13.699])).unwrap();
    check("y", &module.y(), &[62.574999999999996]);
}

#[test]
fn sum_where() {
    let module = SumWhere::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("y", &module.y(), &[8.945712]);
}

#[test]
fn ternary() {
    let module = Ternary::new(1.5_f64, -0.75_f64, 2.25_f64).unwrap();
    check("y", &module.y(), &[1.5]);
}

#[test]
fn vector_of_vectors() {
    let module = VectorOfVectors::new(DVec3::new(-1.198, -0.522, -1.985), DVec3::new(1.32, -1.382, -0.93)).unwrap();
    check("y", &module.y(), &[-1.198, -0.522, -1.985, 2.64, -2.764, -1.86, 1.0]);
}

#[test]
fn trace_product() {
    let module = TraceProduct::new(DMatrix::<f64>::from_column_slice(4, 5, &[-0.708, 0.36, -0.239, -1.14, -1.399, 0.42, -1.042, 0.687, 1.265, 0.552, -0.39, -0.798, -0.482, 0.706, -1.613, 1.496, 1.915, -1.397, 1.871, 0.649])).unwrap();
    check("y", &module.y(), &[23.483973000000002]);
}

#[test]
fn scalar_matrix() {
    let module = ScalarMatrix::new(DMatrix::<f64>::from_column_slice(4, 5, &[-0.708, 0.36, -0.239, -1.14, -1.399, 0.42, -1.042, 0.687, 1.265, 0.552, -0.39, -0.798, -0.482, 0.706, -1.613, 1.496, 1.915, -1.397, 1.871, 0.649]), 1.5_f64).unwrap();
    check("y", &module.y(), &[0.5899999999999999, -0.30000000000000004, 0.19916666666666666, 0.9500000000000001, 1.1658333333333335, -0.35000000000000003, 0.8683333333333335, -0.5725, -1.0541666666666667, -0.46, 0.32499999999999996, 0.665, 0.40166666666666667, -0.5883333333333334, 1.344166666666667, -1.2466666666666666, -1.5958333333333334, 1.1641666666666666, -1.5591666666666664, -0.5408333333333333]);
}

#[test]
fn sum_of_set_values() {
    let module = SumOfSetValues::new(Set::<f64>::from_iter([1.5, 2.5])).unwrap();
    check("y", &module.y(), &[8.5]);
}

#[test]
fn set_operations() {
    let module = SetOperations::new(Set::<i64>::from_iter([1_i64, 2_i64, 3_i64]), Set::<i64>::from_iter([2_i64, 3_i64, 4_i64])).unwrap();
    check("A", &module.A(), &[1.0, 2.0, 3.0, 4.0]);
    check("B", &module.B(), &[2.0, 3.0]);
    check("C", &module.C(), &[1.0]);
    check("D", &module.D(), &[1.0]);
}

#[test]
fn function_of_sequence() {
    let module = FunctionOfSequence::new(vec![DVec3::new(-0.353, 1.691, -1.725), DVec3::new(-0.28, 0.078, 1.804), DVec3::new(-0.996, 1.224, 0.706), DVec3::new(0.868, 0.518, 1.886)]).unwrap();
    check("y", &module.y(), &[8.137083336699469]);
}

#[test]
fn given_block() {
    let module = GivenBlock::new(DMat2::from_cols_array(&[1.669, 0.056, 0.517, -0.013]), DVec2::new(0.541, -1.264), 2.25_f64).unwrap();
    check("y", &module.y(), &[0.24944100000000002, 0.046728]);
    check("z", &module.z(), &[0.56124225, 0.10513800000000001]);
}

#[test]
fn double_sum_weights() {
    let module = DoubleSumWeights::new(DMatrix::<f64>::from_column_slice(4, 4, &[11.003, -3.665, 3.585, 3.262, -3.665, 7.469, -2.673, -1.743, 3.585, -2.673, 9.533, 4.463, 3.262, -1.743, 4.463, 8.6]), vec![DVec3::new(-0.353, 1.691, -1.725), DVec3::new(-0.28, 0.078, 1.804), DVec3::new(-0.996, 1.224, 0.706), DVec3::new(0.868, 0.518, 1.886)]).unwrap();
    check("y", &module.y(), &[66.66737397200002]);
}

#[test]
fn infinity_piece() {
    let module = InfinityPiece::new(1.5_f64).unwrap();
    check("y", &module.y(), &[0.4054651081081644]);
}

#[test]
fn index_set_attribute() {
    let module = IndexSetAttribute::new(Set::<i64>::from_iter([0_i64, 2_i64]), DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("y", &module.y(), &[-1.0749999999999997]);
}

#[test]
fn index_parameter() {
    let module = IndexParameter::new(2_i64, DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("y", &module.y(), &[-1.634]);
}

#[test]
fn integer_parameter() {
    let module = IntegerParameter::new(2_i64, DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("y", &module.y(), &[0.967]);
}

#[test]
fn named_size() {
    let module = NamedSize::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("y", &module.y(), &[-1.5939999999999992]);
    check("z", &module.z(), &[5.0]);
}

#[test]
fn row_vector_times() {
    let module = RowVectorTimes::new(DVec3::new(-1.198, -0.522, -1.985)).unwrap();
    check("y", &module.y(), &[-8.197000000000001]);
    check("z", &module.z(), &[1.0, 2.0, 3.0]);
    check("w", &module.w(), &[-8.197000000000001]);
}

#[test]
fn column_plus_vector() {
    let module = ColumnPlusVector::new(DVec3::new(-1.198, -0.522, -1.985)).unwrap();
    check("y", &module.y(), &[-0.19799999999999995, 1.478, 1.015]);
}

#[test]
fn multiline_matrix() {
    let module = MultilineMatrix::new(1.5_f64, -0.75_f64, 2.25_f64).unwrap();
    check("A", &module.A(), &[1.5, -0.75, -0.75, 2.25]);
}

#[test]
fn negative_cells() {
    let module = NegativeCells::new(1.5_f64, -0.75_f64).unwrap();
    check("A", &module.A(), &[1.5, 0.75, 0.75, 1.5]);
    check("B", &module.B(), &[2.25]);
    check("C", &module.C(), &[2.25, 1.5]);
}

#[test]
fn bars_in_rows() {
    let module = BarsInRows::new(-0.75_f64, DVec3::new(-1.198, -0.522, -1.985)).unwrap();
    check("A", &module.A(), &[0.75, 1.0, 2.376533820504139, 2.0]);
}

#[test]
fn transpose_spellings() {
    let module = TransposeSpellings::new(SMatrix::<f64, 2, 3>::from_column_slice(&[-0.517, 1.03, -1.743, -1.237, 0.075, -0.935])).unwrap();
    check("A", &module.A(), &[-0.517, -1.743, 0.075, 1.03, -1.237, -0.935]);
    check("C", &module.C(), &[-0.517, -1.743, 0.075, 1.03, -1.237, -0.935]);
}

#[test]
fn subscript_digits() {
    let module = SubscriptDigits::new(DVec3::new(-1.198, -0.522, -1.985), DMat2::from_cols_array(&[1.669, 0.056, 0.517, -0.013])).unwrap();
    check("y", &module.y(), &[-0.6809999999999999]);
}

#[test]
fn index_twelve() {
    let module = IndexTwelve::new(SVector::<f64, 13>::from_column_slice(&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0])).unwrap();
    check("y", &module.y(), &[11.0]);
}

#[test]
fn combining() {
    let module = Combining::new(1.5_f64, -0.75_f64).unwrap();
    check("y", &module.y(), &[0.75]);
}

#[test]
fn splitting() {
    let module = Splitting::new(1.5_f64, -0.75_f64).unwrap();
    check("y", &module.y(), &[-2.25]);
}

#[test]
fn letters_product() {
    let module = LettersProduct::new(1.5_f64, -0.75_f64).unwrap();
    check("y", &module.y(), &[-1.125]);
}

#[test]
fn keywords_as_products() {
    let module = KeywordsAsProducts::new(1.0_f64, 2.0_f64, 3.0_f64, 4.0_f64).unwrap();
    check("y", &module.y(), &[14.0]);
}

#[test]
fn division_spellings() {
    let module = DivisionSpellings::new(1.5_f64, -0.75_f64).unwrap();
    check("y", &module.y(), &[-4.0]);
}

#[test]
fn exponent_numbers() {
    let module = ExponentNumbers::new().unwrap();
    check("y", &module.y(), &[2003.515]);
    check("z", &module.z(), &[6.0]);
}

#[test]
fn inequalities() {
    let module = Inequalities::new(1.5_f64, -0.75_f64).unwrap();
    check("y", &module.y(), &[3.0]);
}

#[test]
fn colon_cases() {
    let module = ColonCases::new(1_i64, Set::<i64>::from_iter([1_i64])).unwrap();
    check("y", &module.y(), &[1.0]);
}

#[test]
fn pair_condition() {
    let module = PairCondition::new(1_i64, 2_i64, Set::<(i64, i64)>::from_iter([(1_i64, 2_i64)])).unwrap();
    check("y", &module.y(), &[1.0]);
}

#[test]
fn nuclear() {
    let module = Nuclear::new(DMat3::from_cols_array(&[0.5, -1.099, -1.979, 1.589, -0.799, 1.285, 1.103, 1.494, 1.188])).unwrap();
    check("y", &module.y(), &[6.295553838950498]);
}

#[test]
fn norm_of_difference() {
    let module = NormOfDifference::new(vec![DVec3::new(-0.353, 1.691, -1.725), DVec3::new(-0.28, 0.078, 1.804), DVec3::new(-0.996, 1.224, 0.706), DVec3::new(0.868, 0.518, 1.886)]).unwrap();
    check("y", &module.y(), &[3.8808425631555834]);
}

#[test]
fn inner_bracket_functions() {
    let module = InnerBracketFunctions::new(|x: f64| DVec3::new(x, 2.0 * x, 1.0), 1.5_f64, DVec3::new(-1.198, -0.522, -1.985)).unwrap();
    check("y", &module.y(), &[-5.348]);
}

#[test]
fn function_power() {
    let module = FunctionPower::new(|x: f64| x + 1.0, 1.5_f64, -0.75_f64).unwrap();
    check("y", &module.y(), &[6.25]);
    check("z", &module.z(), &[-1.875]);
}

#[test]
fn subscript_function() {
    let module = SubscriptFunction::new(1.5_f64).unwrap();
    check("y", &module.y(), &[7.5]);
}

#[test]
fn functions_with_subscripts_only() {
    let module = FunctionsWithSubscriptsOnly::new().unwrap();
    check("y", &module.y(), &[16.0]);
}

#[test]
fn locals() {
    let module = Locals::new(1.5_f64).unwrap();
    check("y", &module.y(), &[5.5]);
}

#[test]
fn locals_next_line() {
    let module = LocalsNextLine::new(1.5_f64).unwrap();
    check("y", &module.y(), &[6.75]);
}

#[test]
fn function_vector_result() {
    let module = FunctionVectorResult::new(1.5_f64).unwrap();
    check("y", &module.y(), &[1.5, 2.25, 1.0]);
    check("z", &module.z(), &[2.25]);
}

#[test]
fn piecewise_function() {
    let module = PiecewiseFunction::new(1.5_f64, -0.75_f64).unwrap();
    check("y", &module.y(), &[2.25]);
}

#[test]
fn matrix_of_functions() {
    let module = MatrixOfFunctions::new(1.5_f64, DVec2::new(0.541, -1.264)).unwrap();
    check("y", &module.y(), &[1.299102489169752, 0.450232964844817]);
}

#[test]
fn sequence_functions() {
    let module = SequenceFunctions::new(vec![DVec3::new(-0.353, 1.691, -1.725), DVec3::new(-0.28, 0.078, 1.804), DVec3::new(-0.996, 1.224, 0.706), DVec3::new(0.868, 0.518, 1.886)]).unwrap();
    check("y", &module.y(), &[31.432615460879866]);
}

#[test]
fn set_of_vectors() {
    let module = SetOfVectors::new(Set::from_iter([DVec3::new(3.0, 4.0, 0.0), DVec3::new(0.0, 5.0, 12.0)])).unwrap();
    check("y", &module.y(), &[18.0]);
}

#[test]
fn set_of_triples() {
    let module = SetOfTriples::new(Set::from_iter([(1_i64, 2_i64, 3_i64), (2, 2, 2)])).unwrap();
    check("y", &module.y(), &[14.0]);
}

#[test]
fn tuple_parameter() {
    let module = TupleParameter::new((1.5, 2_i64)).unwrap();
    check("y", &module.y(), &[3.5]);
}

#[test]
fn destructure_set() {
    let module = DestructureSet::new(Set::<i64>::from_iter([4_i64, 2_i64])).unwrap();
    check("a", &module.a(), &[2.0]);
    check("b", &module.b(), &[4.0]);
}

#[test]
fn destructure_vector() {
    let module = DestructureVector::new(DVec3::new(-1.198, -0.522, -1.985)).unwrap();
    check("a", &module.a(), &[-1.198]);
    check("b", &module.b(), &[-0.522]);
    check("c", &module.c(), &[-1.985]);
}

#[test]
fn svd_values() {
    let module = SvdValues::new(DMat3::from_cols_array(&[0.5, -1.099, -1.979, 1.589, -0.799, 1.285, 1.103, 1.494, 1.188])).unwrap();
    check("s", &module.s(), &[3.081272478624125, 2.0480123059244515, 1.1662690544019232]);
}

#[test]
fn null_space() {
    let module = NullSpace::new(SMatrix::<f64, 2, 3>::from_column_slice(&[1.0, 2.0, 2.0, 4.0, 3.0, 6.0])).unwrap();
    check("y", &module.y(), &[0.0]);
}

#[test]
fn orthogonal_basis() {
    let module = OrthogonalBasis::new(SMatrix::<f64, 2, 3>::from_column_slice(&[1.0, 2.0, 2.0, 4.0, 3.0, 6.0])).unwrap();
    check("y", &module.y(), &[0.0]);
}

#[test]
fn inverse_vec() {
    let module = InverseVec::new(vec![DVec3::new(-0.353, 1.691, -1.725), DVec3::new(-0.28, 0.078, 1.804), DVec3::new(-0.996, 1.224, 0.706), DVec3::new(0.868, 0.518, 1.886)]).unwrap();
    check("y", &module.y(), &[-0.706, 3.382, -3.45, -0.56, 0.156, 3.608, -1.992, 2.448, 1.412, 1.736, 1.036, 3.772]);
}

#[test]
fn positive_part() {
    let module = PositivePart::new(DMat3::from_cols_array(&[0.5, 0.245, -0.43800000000000006, 0.245, -0.799, 1.3895, -0.43800000000000006, 1.3895, 1.188])).unwrap();
    check("B", &module.B(), &[0.5623045583811054, -0.02777052972187728, -0.29215654934104707, -0.027770529721877307, 0.3951945151049709, 0.7509946269361036, -0.292156549341047, 0.7509946269361036, 1.5293925506060693]);
}

#[test]
fn rectangular_diag() {
    let module = RectangularDiag::new(DVec3::new(-1.198, -0.522, -1.985)).unwrap();
    check("D", &module.D(), &[-1.198, 0.0, 0.0, 0.0, -0.522, 0.0, 0.0, 0.0, -1.985, 0.0, 0.0, 0.0]);
}

#[test]
fn identity_named() {
    let module = IdentityNamed::new(DMatrix::<f64>::from_column_slice(4, 4, &[11.003, -3.665, 3.585, 3.262, -3.665, 7.469, -2.673, -1.743, 3.585, -2.673, 9.533, 4.463, 3.262, -1.743, 4.463, 8.6])).unwrap();
    check("y", &module.y(), &[12.003, -3.665, 3.585, 3.262, -3.665, 8.469000000000001, -2.673, -1.743, 3.585, -2.673, 10.533, 4.463, 3.262, -1.743, 4.463, 9.6]);
}

#[test]
fn own_identity_symbol() {
    let module = OwnIdentitySymbol::new(DMatrix::<f64>::from_column_slice(4, 4, &[11.003, -3.665, 3.585, 3.262, -3.665, 7.469, -2.673, -1.743, 3.585, -2.673, 9.533, 4.463, 3.262, -1.743, 4.463, 8.6])).unwrap();
    check("y", &module.y(), &[33.009, -10.995000000000001, 10.754999999999999, 9.786, -10.995000000000001, 22.407, -8.019, -5.229, 10.754999999999999, -8.019, 28.598999999999997, 13.389, 9.786, -5.229, 13.389, 25.799999999999997]);
}

#[test]
fn own_transpose_letter() {
    let module = OwnTransposeLetter::new(DMat2::from_cols_array(&[1.669, 0.056, 0.517, -0.013])).unwrap();
    check("y", &module.y(), &[4.788697, 0.862145, 0.862145, 2.267458]);
}

#[test]
fn left_associative() {
    let module = LeftAssociative::new(1.5_f64, -0.75_f64, 2.25_f64).unwrap();
    check("y", &module.y(), &[-4.5]);
}

#[test]
fn power_tower() {
    let module = PowerTower::new(2.0_f64, 3.0_f64).unwrap();
    check("y", &module.y(), &[264.0]);
}

#[test]
fn power_juxtaposed() {
    let module = PowerJuxtaposed::new(1.5_f64, -0.75_f64).unwrap();
    check("y", &module.y(), &[-3.375]);
}

#[test]
fn power_then_cross() {
    let module = PowerThenCross::new(1.5_f64, DVec3::new(-1.198, -0.522, -1.985), DVec3::new(1.32, -1.382, -0.93)).unwrap();
    check("y", &module.y(), &[-5.080072499999999, -8.402265, 5.2755209999999995]);
}

#[test]
fn triple_product() {
    let module = TripleProduct::new(DVec3::new(-1.198, -0.522, -1.985), DVec3::new(1.32, -1.382, -0.93), DVec3::new(1.521, 0.039, 1.389)).unwrap();
    check("y", &module.y(), &[-0.32301330599999917]);
    check("z", &module.z(), &[-0.32301330599999917]);
}

#[test]
fn sqrt_forms() {
    let module = SqrtForms::new(4.0_f64, 9.0_f64).unwrap();
    check("y", &module.y(), &[26.0]);
}

#[test]
fn sum_of_negatives() {
    let module = SumOfNegatives::new(vec![0.559_f64, 0.967_f64, -1.634_f64, 0.165_f64, 0.031_f64], 1.5_f64).unwrap();
    check("y", &module.y(), &[-0.1320000000000002]);
}

#[test]
fn sum_divided() {
    let module = SumDivided::new(vec![0.559_f64, 0.967_f64, -1.634_f64, 0.165_f64, 0.031_f64], 1.5_f64, -0.75_f64).unwrap();
    check("y", &module.y(), &[0.8239999999999997]);
}

#[test]
fn empty_sum() {
    let module = EmptySum::new(Set::<i64>::from_iter([])).unwrap();
    check("y", &module.y(), &[0.0]);
    check("z", &module.z(), &[0.0]);
}

#[test]
fn sum_over_union() {
    let module = SumOverUnion::new(Set::<i64>::from_iter([1_i64]), Set::<i64>::from_iter([1_i64, 5_i64])).unwrap();
    check("y", &module.y(), &[9.0]);
}

#[test]
fn builder_forms() {
    let module = BuilderForms::new(Set::<i64>::from_iter([1_i64, 3_i64, 4_i64])).unwrap();
    check("A", &module.A(), &[3.0, 4.0]);
    check("B", &module.B(), &[6.0, 8.0]);
    check("C", &module.C(), &[1.0, 3.0, 4.0]);
}

#[test]
fn builder_pairs() {
    let module = BuilderPairs::new(Set::<(i64, i64)>::from_iter([(1_i64, 2_i64), (4_i64, 3_i64)])).unwrap();
    check("A", &module.A(), &[3.0]);
}

#[test]
fn set_comparison() {
    let module = SetComparison::new(Set::<i64>::from_iter([1_i64, 2_i64]), Set::<i64>::from_iter([2_i64, 1_i64])).unwrap();
    check("y", &module.y(), &[1.0]);
}

#[test]
fn set_item() {
    let module = SetItem::new(Set::<i64>::from_iter([5_i64, 3_i64])).unwrap();
    check("y", &module.y(), &[3.0]);
}

#[test]
fn sum_with_condition_set() {
    let module = SumWithConditionSet::new(Set::<i64>::from_iter([1_i64, 3_i64]), DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("y", &module.y(), &[-1.634]);
}

#[test]
fn matrix_by_scalar_function() {
    let module = MatrixByScalarFunction::new().unwrap();
    check("A", &module.A(), &[11.0, 12.0, 21.0, 22.0, 31.0, 32.0]);
}

#[test]
fn diagonal_then_entries() {
    let module = DiagonalThenEntries::new(DMatrix::<f64>::from_column_slice(4, 4, &[11.003, -3.665, 3.585, 3.262, -3.665, 7.469, -2.673, -1.743, 3.585, -2.673, 9.533, 4.463, 3.262, -1.743, 4.463, 8.6])).unwrap();
    check("y", &module.y(), &[11.003, 7.469, 9.533, 8.6]);
}

#[test]
fn trace_by_sum() {
    let module = TraceBySum::new(DMatrix::<f64>::from_column_slice(4, 4, &[11.003, -3.665, 3.585, 3.262, -3.665, 7.469, -2.673, -1.743, 3.585, -2.673, 9.533, 4.463, 3.262, -1.743, 4.463, 8.6])).unwrap();
    check("y", &module.y(), &[36.605000000000004]);
}

#[test]
fn shifted_sum() {
    let module = ShiftedSum::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031]), 5_i64).unwrap();
    check("y", &module.y(), &[10.186022]);
}

#[test]
fn block_of_vectors() {
    let module = BlockOfVectors::new(DVec3::new(-1.198, -0.522, -1.985), DVec3::new(1.32, -1.382, -0.93)).unwrap();
    check("A", &module.A(), &[-1.198, -0.522, -1.985, 1.32, -1.382, -0.93]);
    check("B", &module.B(), &[-1.198, 1.32, -0.522, -1.382, -1.985, -0.93]);
}

#[test]
fn zero_block_named() {
    let module = ZeroBlockNamed::new(DMatrix::<f64>::from_column_slice(4, 4, &[11.003, -3.665, 3.585, 3.262, -3.665, 7.469, -2.673, -1.743, 3.585, -2.673, 9.533, 4.463, 3.262, -1.743, 4.463, 8.6]), 2_i64).unwrap();
    check("B", &module.B(), &[11.003, -3.665, 3.585, 3.262, 0.0, 0.0, -3.665, 7.469, -2.673, -1.743, 0.0, 0.0, 3.585, -2.673, 9.533, 4.463, 0.0, 0.0, 3.262, -1.743, 4.463, 8.6, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
}

#[test]
fn size_product() {
    let module = SizeProduct::new(DMatrix::<f64>::from_column_slice(4, 5, &[-0.708, 0.36, -0.239, -1.14, -1.399, 0.42, -1.042, 0.687, 1.265, 0.552, -0.39, -0.798, -0.482, 0.706, -1.613, 1.496, 1.915, -1.397, 1.871, 0.649])).unwrap();
    check("y", &module.y(), &[-0.708, 0.36, -0.239, -1.14, -1.399, 0.42, -1.042, 0.687, 1.265, 0.552, -0.39, -0.798, -0.482, 0.706, -1.613, 1.496, 1.915, -1.397, 1.871, 0.649]);
}

#[test]
fn cross_of_sums() {
    let module = CrossOfSums::new(DVec3::new(-1.198, -0.522, -1.985), DVec3::new(1.32, -1.382, -0.93)).unwrap();
    check("y", &module.y(), &[4.51562, 7.468679999999999, -4.6893519999999995]);
}

#[test]
fn registration() {
    let module = Registration::new(DMat3::from_cols_array(&[0.5, -1.099, -1.979, 1.589, -0.799, 1.285, 1.103, 1.494, 1.188]), DVec3::new(-1.198, -0.522, -1.985), vec![DVec3::new(-0.353, 1.691, -1.725), DVec3::new(-0.28, 0.078, 1.804), DVec3::new(-0.996, 1.224, 0.706), DVec3::new(0.868, 0.518, 1.886)], vec![DVec3::new(-1.148, 1.662, 1.361), DVec3::new(-1.55, 0.415, -0.083), DVec3::new(0.379, 0.637, -0.773), DVec3::new(1.845, -0.137, 0.512)]).unwrap();
    check("q", &module.q(), &[63.08063667406002]);
}

#[test]
fn normal_equations() {
    let module = NormalEquations::new(DMatrix::<f64>::from_column_slice(5, 4, &[-0.708, -1.399, 1.265, -0.482, 1.915, 0.36, 0.42, 0.552, 0.706, -1.397, -0.239, -1.042, -0.39, -1.613, 1.871, -1.14, 0.687, -0.798, 1.496, 0.649]), DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("x", &module.x(), &[-0.3965796865097306, -7.14285445724729, -4.403790034043785, -1.473387692820929]);
    check("z", &module.z(), &[-0.3965796865097306, -7.14285445724729, -4.403790034043785, -1.473387692820929]);
}

#[test]
fn kalman() {
    let module = Kalman::new(DMat4::from_cols_array(&[11.003, -3.665, 3.585, 3.262, -3.665, 7.469, -2.673, -1.743, 3.585, -2.673, 9.533, 4.463, 3.262, -1.743, 4.463, 8.6]), SMatrix::<f64, 2, 4>::from_column_slice(&[-0.708, 0.36, -1.399, 0.42, 1.265, 0.552, -0.482, 0.706]), DMat2::from_cols_array(&[2.285, -0.046, -0.046, 3.527])).unwrap();
    check("K", &module.K(), &[-0.030660202821807547, -0.34876329141941853, 0.3261760357707228, 0.0007710513220993445, 0.4083050853035166, 0.009035772136236062, 0.4572457319939005, 0.5393077170171039]);
    check("Q", &module.Q(), &[8.275053221350012, -3.620960605880228, 0.42193743503148523, -0.35357332033764927, -3.620960605880229, 3.8514487897636625, 1.1240237096231709, -1.2558236282805224, 0.4219374350314859, 1.1240237096231702, 1.985730295037254, -0.1733837937912119, -0.353573320337649, -1.2558236282805224, -0.17338379379121285, 3.7571430919697355]);
}

#[test]
fn lagrangian() {
    let module = Lagrangian::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031]), DVector::<f64>::from_column_slice(&[-1.596, -0.478, -1.465, 0.65]), DMatrix::<f64>::from_column_slice(4, 5, &[-0.708, 0.36, -0.239, -1.14, -1.399, 0.42, -1.042, 0.687, 1.265, 0.552, -0.39, -0.798, -0.482, 0.706, -1.613, 1.496, 1.915, -1.397, 1.871, 0.649]), DVector::<f64>::from_column_slice(&[1.056, 1.261, 0.92, 1.547]), 3.0_f64).unwrap();
    check("y", &module.y(), &[56.102945834739]);
}

#[test]
fn softmax() {
    let module = Softmax::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("s", &module.s(), &[0.25776344333733386, 0.38762651197854897, 0.028761632037739626, 0.17382382356503498, 0.15202458908134248]);
}

#[test]
fn gaussian() {
    let module = Gaussian::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031]), DVector::<f64>::from_column_slice(&[1.485, -0.555, 0.393, -1.763, -0.449]), DMatrix::<f64>::from_column_slice(5, 5, &[13.914, 1.72, -1.661, -4.641, 1.417, 1.72, 11.257, -3.451, 3.467, 6.046, -1.661, -3.451, 8.616, -1.985, -4.013, -4.641, 3.467, -1.985, 13.767, 4.423, 1.417, 6.046, -4.013, 4.423, 13.699])).unwrap();
    check("p", &module.p(), &[2.0104281070280202e-05]);
}

#[test]
fn householder() {
    let module = Householder::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031]), DVector::<f64>::from_column_slice(&[1.485, -0.555, 0.393, -1.763, -0.449])).unwrap();
    check("y", &module.y(), &[1.6701793612914475, -0.23466289379458016, -0.14829351762115417, -1.7083406178656728, -0.4387306615383992]);
}

#[test]
fn skew() {
    let module = Skew::new(DVec3::new(-1.198, -0.522, -1.985), DVec3::new(1.32, -1.382, -0.93)).unwrap();
    check("y", &module.y(), &[-2.2578099999999997, -3.73434, 2.3446759999999998]);
}

#[test]
fn arap() {
    let module = Arap::new(DMatrix::<f64>::from_column_slice(4, 4, &[11.003, -3.665, 3.585, 3.262, -3.665, 7.469, -2.673, -1.743, 3.585, -2.673, 9.533, 4.463, 3.262, -1.743, 4.463, 8.6]), vec![DVec3::new(-0.353, 1.691, -1.725), DVec3::new(-0.28, 0.078, 1.804), DVec3::new(-0.996, 1.224, 0.706), DVec3::new(0.868, 0.518, 1.886)], vec![DVec3::new(-1.148, 1.662, 1.361), DVec3::new(-1.55, 0.415, -0.083), DVec3::new(0.379, 0.637, -0.773), DVec3::new(1.845, -0.137, 0.512)], vec![DMat3::from_cols_array(&[1.972, 1.301, -1.633, -1.408, 1.682, 1.951, 0.851, -1.506, -1.533]), DMat3::from_cols_array(&[-1.293, 1.002, -1.131, 0.3, -1.238, 1.076, -0.215, 1.658, -1.73]), DMat3::from_cols_array(&[-0.106, -0.751, -1.773, -1.87, 0.879, 1.981, -0.745, -0.18, 1.555]), DMat3::from_cols_array(&[1.665, -1.091, 0.013, -1.014, -1.5, -1.507, -0.424, -1.868, -1.295])]).unwrap();
    check("E", &module.E(), &[1053.9969028569576]);
}

#[test]
fn names_with_backticks() {
    let module = NamesWithBackticks::new(1.5_f64, -0.75_f64).unwrap();
    check("my_name", &module.my_name(), &[2.25]);
}

#[test]
fn parenthesised_index() {
    let module = ParenthesisedIndex::new(DMat2::from_cols_array(&[1.669, 0.056, 0.517, -0.013]), DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("y", &module.y(), &[0.152]);
}

#[test]
fn entries_with_sizes() {
    let module = EntriesWithSizes::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031]), DVector::<f64>::from_column_slice(&[-1.596, -0.478, -1.465, 0.65])).unwrap();
    check("A", &module.A(), &[-0.8921640000000002, -1.543332, 2.607864, -0.26334, -0.049476, -0.267202, -0.46222599999999997, 0.781052, -0.07887, -0.014818, -0.8189350000000001, -1.416655, 2.3938099999999998, -0.24172500000000002, -0.045415000000000004, 0.36335000000000006, 0.62855, -1.0621, 0.10725000000000001, 0.02015]);
}

#[test]
fn semicolon_items() {
    let module = SemicolonItems::new().unwrap();
    check("c", &module.c(), &[4.0]);
}

#[test]
fn comment() {
    let module = Comment::new().unwrap();
    check("b", &module.b(), &[2.0]);
}

#[test]
fn break_after_operator() {
    let module = BreakAfterOperator::new(1.5_f64, -0.75_f64).unwrap();
    check("y", &module.y(), &[0.75]);
}

#[test]
fn breaks_in_parentheses() {
    let module = BreaksInParentheses::new(1.5_f64, -0.75_f64).unwrap();
    check("y", &module.y(), &[0.75]);
}

#[test]
fn sum_inside_norm() {
    let module = SumInsideNorm::new(vec![DVec3::new(-0.353, 1.691, -1.725), DVec3::new(-0.28, 0.078, 1.804), DVec3::new(-0.996, 1.224, 0.706), DVec3::new(0.868, 0.518, 1.886)]).unwrap();
    check("y", &module.y(), &[1.1882188098449264]);
}

#[test]
fn function_of_matrix_any() {
    let module = FunctionOfMatrixAny::new(DMat2::from_cols_array(&[1.669, 0.056, 0.517, -0.013]), DMat3::from_cols_array(&[0.489, -1.359, -1.857, 1.956, 0.45, 0.06, -1.139, -1.824, -0.135])).unwrap();
    check("y", &module.y(), &[2.46]);
}

#[test]
fn mutual_order() {
    let module = MutualOrder::new().unwrap();
    check("c", &module.c(), &[9.0]);
}

#[test]
fn int_mapping() {
    let module = IntMapping::new(vec![1_i64, 2_i64], vec![1.5_f64, -0.75_f64]).unwrap();
    check("y", &module.y(), &[0.0]);
}

#[test]
fn vector_index_vector() {
    let module = VectorIndexVector::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031]), vec![2_i64, 5_i64]).unwrap();
    check("y", &module.y(), &[0.967, 0.031]);
}

#[test]
fn det_of_literal() {
    let module = DetOfLiteral::new(1.5_f64, -0.75_f64, 2.25_f64, DVec3::new(-1.198, -0.522, -1.985), DVec3::new(1.32, -1.382, -0.93), DVec3::new(1.521, 0.039, 1.389)).unwrap();
    check("y", &module.y(), &[3.9375]);
    check("z", &module.z(), &[-0.32301330599999967]);
}

#[test]
fn mod_free() {
    let module = ModFree::new().unwrap();
    check("y", &module.y(), &[5.0]);
}

#[test]
fn pi() {
    let module = Pi::new(1.5_f64).unwrap();
    check("y", &module.y(), &[9.42477796076938]);
}

#[test]
fn sequence_of_sequences() {
    let module = SequenceOfSequences::new(vec![DVec3::new(-0.353, 1.691, -1.725), DVec3::new(-0.28, 0.078, 1.804), DVec3::new(-0.996, 1.224, 0.706), DVec3::new(0.868, 0.518, 1.886)]).unwrap();
    check("y", &module.y(), &[5.421]);
}

#[test]
fn min_of_expression() {
    let module = MinOfExpression::new(Set::<i64>::from_iter([1_i64, 2_i64, 3_i64, 4_i64]), vec![DVec3::new(-0.353, 1.691, -1.725), DVec3::new(-0.28, 0.078, 1.804), DVec3::new(-0.996, 1.224, 0.706), DVec3::new(0.868, 0.518, 1.886)]).unwrap();
    check("y", &module.y(), &[1.728764877014801]);
}

#[test]
fn argmin_set() {
    let module = ArgminSet::new(Set::<i64>::from_iter([1_i64, 2_i64, 3_i64, 4_i64, 5_i64]), DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("y", &module.y(), &[3.0]);
}

#[test]
fn max_box() {
    let module = MaxBox::new().unwrap();
    check("y", &module.y(), &[0.25]);
}

#[test]
fn rosenbrock() {
    let module = Rosenbrock::new().unwrap();
    check("y", &module.y(), &[1.0, 1.0]);
}

#[test]
fn two_variables() {
    let module = TwoVariables::new().unwrap();
    check("y", &module.y(), &[3.0]);
}

#[test]
fn sine_integral() {
    let module = SineIntegral::new().unwrap();
    check("y", &module.y(), &[2.0]);
}

#[test]
fn nested_integral() {
    let module = NestedIntegral::new().unwrap();
    check("y", &module.y(), &[1.0]);
}

#[test]
fn integral_expression() {
    let module = IntegralExpression::new(0.0_f64, 3.0_f64).unwrap();
    check("y", &module.y(), &[24.0]);
}

#[test]
fn ragged_matrices() {
    let module = RaggedMatrices::new(vec![DMatrix::<f64>::from_column_slice(4, 5, &[-0.708, 0.36, -0.239, -1.14, -1.399, 0.42, -1.042, 0.687, 1.265, 0.552, -0.39, -0.798, -0.482, 0.706, -1.613, 1.496, 1.915, -1.397, 1.871, 0.649]), DMatrix::<f64>::from_column_slice(2, 2, &[1.669, 0.056, 0.517, -0.013])]).unwrap();
    check("y", &module.y(), &[26.540128000000003]);
}

#[test]
fn sparse_declared_rows() {
    let module = SparseDeclaredRows::new(3_i64, Set::<(i64, i64)>::from_iter([(1_i64, 2_i64)]), DVector::<f64>::from_column_slice(&[-1.198, -0.522, -1.985])).unwrap();
    check("y", &module.y(), &[-1.459, -0.522, -1.985]);
}

#[test]
fn mutual_recursion() {
    let module = MutualRecursion::new(vec![0_i64, 1_i64, 2_i64, 5_i64, 9_i64]).unwrap();
    check("y", &module.y(), &[1.0, 1.0, 2.0, 3.0, 6.0]);
    check("z", &module.z(), &[0.0, 0.0, 1.0, 3.0, 6.0]);
}

#[test]
fn recursion_in_a_circle() {
    let module = RecursionInACircle::new(1.5_f64).unwrap();
    check("y", &module.y(), &[4.65625]);
    check("z", &module.z(), &[3.3125]);
}

#[test]
fn recursion_from_integer_to_real() {
    let module = RecursionFromIntegerToReal::new().unwrap();
    check("y", &module.y(), &[1.875]);
}

#[test]
fn sizes_of_sequences() {
    let module = SizesOfSequences::new(vec![DVec3::new(-0.353, 1.691, -1.725), DVec3::new(-0.28, 0.078, 1.804), DVec3::new(-0.996, 1.224, 0.706), DVec3::new(0.868, 0.518, 1.886)], vec![DMatrix::<f64>::from_column_slice(2, 5, &[-0.708, 0.36, -1.399, 0.42, 1.265, 0.552, -0.482, 0.706, 1.915, -1.397]), DMatrix::<f64>::from_column_slice(2, 5, &[-0.708, 0.36, -1.399, 0.42, 1.265, 0.552, -0.482, 0.706, 1.915, -1.397]), DMatrix::<f64>::from_column_slice(2, 5, &[-0.708, 0.36, -1.399, 0.42, 1.265, 0.552, -0.482, 0.706, 1.915, -1.397]), DMatrix::<f64>::from_column_slice(2, 5, &[-0.708, 0.36, -1.399, 0.42, 1.265, 0.552, -0.482, 0.706, 1.915, -1.397])], vec![-0.669_f64, -0.407_f64, -1.188_f64, -1.797_f64], vec![DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031]), DVector::<f64>::from_column_slice(&[-1.198, -0.522, -1.985])]).unwrap();
    check("k", &module.k(), &[4.0]);
    check("r", &module.r(), &[3.0]);
    check("l", &module.l(), &[4.0]);
    check("s", &module.s(), &[2.0]);
    check("t", &module.t(), &[5.0]);
    check("n", &module.n(), &[4.0]);
    check("m", &module.m(), &[4.0]);
    check("p", &module.p(), &[2.0]);
    check("u", &module.u(), &[5.0, 3.0]);
}

#[test]
fn columns_and_vectors() {
    let module = ColumnsAndVectors::new(DVec3::new(-1.198, -0.522, -1.985), 1.5_f64).unwrap();
    check("y", &module.y(), &[-0.19799999999999995, 1.478, 1.015]);
    check("z", &module.z(), &[-2.198, -2.5220000000000002, -4.985]);
    check("s", &module.s(), &[2.5]);
    check("t", &module.t(), &[15.831999999999999]);
    check("p", &module.p(), &[-0.19799999999999995, 8.0, -0.9850000000000001]);
    check("r", &module.r(), &[-1.198, -0.522, -1.985]);
}

#[test]
fn matrix_before_vector() {
    let module = MatrixBeforeVector::new(1.5_f64, -0.75_f64).unwrap();
    check("y", &module.y(), &[1.5]);
    check("z", &module.z(), &[11.5]);
}

#[test]
fn function_by_another_name() {
    let module = FunctionByAnotherName::new(|x: f64| x * x + 1.0, [(|x: f64| x) as fn(f64) -> f64, |x: f64| 3.0 * x], 1.5_f64).unwrap();
    check("y", &module.y(), &[9.25]);
}

#[test]
fn set_added_to() {
    let module = SetAddedTo::new(Set::<i64>::from_iter([2_i64, 5_i64])).unwrap();
    check("T", &module.T(), &[2.0, 5.0, 7.0]);
}

#[test]
fn optima_in_cases() {
    let module = OptimaInCases::new(1.5_f64, -0.75_f64).unwrap();
    check("y", &module.y(), &[4.25]);
    check("z", &module.z(), &[-1.0]);
}

#[test]
fn ranked_overloads() {
    let module = RankedOverloads::new(DVec3::new(-1.198, -0.522, -1.985), DVec2::new(0.541, -1.264)).unwrap();
    check("y", &module.y(), &[1.0, 2.0, 3.0, 4.0, 3.0, 5.0]);
}

#[test]
fn functions_of_functions() {
    let module = FunctionsOfFunctions::new(|x: f64| x * x - 2.0, vec![|x: f64| x + 1.0, |x: f64| 2.0 * x], |x: DVector<f64>| x.sum(), DVector::<f64>::from_column_slice(&[-1.198, -0.522, -1.985])).unwrap();
    check("y", &module.y(), &[63.0]);
    check("z", &module.z(), &[1.4142135623730951]);
    check("w", &module.w(), &[13.727025000000001]);
    check("s", &module.s(), &[7.0]);
    check("twice(|x: f64| x + 1.0, 5.0)", &module.twice(|x: f64| x + 1.0, 5.0), &[7.0]);
    check("all([|x: f64| x + 1.0, |x: f64| x + 2.0], 5.0)", &module.all([|x: f64| x + 1.0, |x: f64| x + 2.0], 5.0), &[13.0]);
}

#[test]
fn sets_of_integers_and_reals() {
    let module = SetsOfIntegersAndReals::new(Set::<i64>::from_iter([1_i64, 2_i64, 3_i64, 4_i64])).unwrap();
    check("A", &module.A(), &[1.0, 2.0, 4.0, 9.0, 16.0]);
    check("B", &module.B(), &[4.0]);
    check("C", &module.C(), &[1.0, 2.0, 4.0]);
    check("q", &module.q(), &[2.0]);
    check("r", &module.r(), &[21.0]);
    check("D", &module.D(), &[4.0, 9.0, 16.0]);
    check("E", &module.E(), &[]);
}

#[test]
fn roots_of_matrices() {
    let module = RootsOfMatrices::new(DMat3::from_cols_array(&[2.0, 0.5, 0.0, 1.0, 3.0, -0.4, 0.0, 1.0, 1.5]), 2.3_f64).unwrap();
    check("B", &module.B(), &[1.3963385133737798, 0.1590144736609014, 0.008154135125295416, 0.31802894732180226, 1.7306757309461756, -0.13536571405401646, -0.040770675626479645, 0.3384142851350424, 1.2434396410568507]);
    check("C", &module.C(), &[5.887211828901227, 3.7977667269574966, -0.37616040442549, 7.595533453914998, 12.73042447396525, -2.6620529771405095, 1.8808020221274417, 6.6551324428512695, 1.8073247986246133]);
    check("D", &module.D(), &[0.7305736066481175, -0.06480869992245541, -0.011846229895791168, -0.12961739984491147, 0.5772637470116252, 0.06369318983375574, 0.05923114947895435, -0.15923297458438837, 0.7864976341487302]);
    check("E", &module.E(), &[2.0, 0.5, 0.0, 1.0, 3.0, -0.4, 0.0, 1.0, 1.5]);
}

#[test]
fn ragged_total() {
    let module = RaggedTotal::new(vec![DVector::<f64>::from_column_slice(&[0.882, 0.093]), DVector::<f64>::from_column_slice(&[0.923, -1.661, 0.251]), DVector::<f64>::from_column_slice(&[0.232]), DVector::<f64>::from_column_slice(&[1.728, -1.842, -0.189, 0.524])]).unwrap();
    check("s", &module.s(), &[0.9409999999999998]);
    check("t", &module.t(), &[-0.7729999999999999]);
}

#[test]
fn ragged_systems() {
    let module = RaggedSystems::new(vec![DVector::<f64>::from_column_slice(&[0.882, 0.093]), DVector::<f64>::from_column_slice(&[0.923, -1.661, 0.251]), DVector::<f64>::from_column_slice(&[0.232]), DVector::<f64>::from_column_slice(&[1.728, -1.842, -0.189, 0.524])], vec![DMatrix::<f64>::from_column_slice(2, 2, &[0.203, 0.373, -1.703, -1.111]), DMatrix::<f64>::from_column_slice(3, 3, &[-1.218, -0.183, 0.214, 1.515, 1.001, 1.228, -1.209, 0.829, -0.137]), DMatrix::<f64>::from_column_slice(1, 1, &[0.482]), DMatrix::<f64>::from_column_slice(4, 4, &[1.276, 0.233, -0.134, 1.307, 0.712, -0.416, 1.022, -0.476, 0.567, 0.977, 0.015, 1.379, -0.375, -0.478, -0.648, 1.141])]).unwrap();
    check("y", &module.y(), &[-2.005250362472723, -0.7569382405061438, 0.7720119331090928, -0.11867078431455476, -1.6899063463717332, 0.4813278008298756, 2.1044091463935395, 0.47280410211109686, -1.912961756276449, 0.5579020685133644]);
    check("s", &module.s(), &[0.6017474419999995]);
}

#[test]
fn sum_over_set_and_later() {
    let module = SumOverSetAndLater::new(Set::<i64>::from_iter([1_i64, 3_i64, 6_i64]), vec![1.494_f64, -1.283_f64, -1.455_f64, -1.547_f64, 1.918_f64, 1.766_f64]).unwrap();
    check("y", &module.y(), &[-4.007229000000001]);
}

#[test]
fn entries_in_set() {
    let module = EntriesInSet::new(vec![1.494_f64, -1.283_f64, -1.455_f64, -1.547_f64, 1.918_f64, 1.766_f64], Set::<i64>::from_iter([2_i64, 5_i64])).unwrap();
    check("y", &module.y(), &[-1.0, -1.283, -1.0, -1.0, 1.918, -1.0]);
}

#[test]
fn matrix_by_order() {
    let module = MatrixByOrder::new(DVector::<f64>::from_column_slice(&[1.494, -1.283, -1.455, -1.547, 1.918, 1.766])).unwrap();
    check("M", &module.M(), &[1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.916802, 1.0, 0.0, 0.0, 0.0, 0.0, -2.17377, 1.866765, 1.0, 0.0, 0.0, 0.0, -2.3112179999999998, 1.9848009999999998, 2.250885, 1.0, 0.0, 0.0, 2.8654919999999997, -2.460794, -2.79069, -2.9671459999999996, 1.0, 0.0, 2.638404, -2.265778, -2.5695300000000003, -2.732002, 3.387188, 1.0]);
}

#[test]
fn bidiagonal() {
    let module = Bidiagonal::new(DVector::<f64>::from_column_slice(&[1.494, -1.283, -1.455, -1.547, 1.918, 1.766])).unwrap();
    check("M", &module.M(), &[1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.494, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.283, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.455, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.547, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.918, 1.0]);
    check("y", &module.y(), &[-0.4228019999999999, 0.5837650000000001, 0.7958849999999997, -4.514145999999999, 5.305188, 1.766]);
}

#[test]
fn triangular_sum() {
    let module = TriangularSum::new(DMatrix::<f64>::from_column_slice(6, 6, &[-1.838, 1.523, 0.726, 1.678, -1.634, 0.811, -0.739, 1.044, 0.943, 0.387, 1.862, 0.575, 0.4, 1.316, -0.793, -0.682, 0.302, 1.802, -1.734, 1.044, -1.329, 1.747, 1.215, -0.266, -1.054, 0.831, 1.026, -1.379, -0.872, -0.34, -0.14, 1.399, -1.337, 0.058, 1.207, 0.768])).unwrap();
    check("y", &module.y(), &[8.958]);
}

#[test]
fn signed_identity_blocks() {
    let module = SignedIdentityBlocks::new(DMatrix::<f64>::from_column_slice(4, 5, &[-0.708, 0.36, -0.239, -1.14, -1.399, 0.42, -1.042, 0.687, 1.265, 0.552, -0.39, -0.798, -0.482, 0.706, -1.613, 1.496, 1.915, -1.397, 1.871, 0.649])).unwrap();
    check("B", &module.B(), &[1.0, 0.0, 0.0, 0.0, -0.708, -1.399, 1.265, -0.482, 1.915, 0.0, 1.0, 0.0, 0.0, 0.36, 0.42, 0.552, 0.706, -1.397, 0.0, 0.0, 1.0, 0.0, -0.239, -1.042, -0.39, -1.613, 1.871, 0.0, 0.0, 0.0, 1.0, -1.14, 0.687, -0.798, 1.496, 0.649, -0.708, 0.36, -0.239, -1.14, -1.0, -0.0, -0.0, -0.0, -0.0, -1.399, 0.42, -1.042, 0.687, -0.0, -1.0, -0.0, -0.0, -0.0, 1.265, 0.552, -0.39, -0.798, -0.0, -0.0, -1.0, -0.0, -0.0, -0.482, 0.706, -1.613, 1.496, -0.0, -0.0, -0.0, -1.0, -0.0, 1.915, -1.397, 1.871, 0.649, -0.0, -0.0, -0.0, -0.0, -1.0]);
    check("C", &module.C(), &[-0.708, 0.36, -0.239, -1.14, 1.0, 1.0, -1.399, 0.42, -1.042, 0.687, 1.0, 1.0, 1.265, 0.552, -0.39, -0.798, 1.0, 1.0, -0.482, 0.706, -1.613, 1.496, 1.0, 1.0, 1.915, -1.397, 1.871, 0.649, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 3.0, 0.0, 0.0, 0.0, 0.0, 2.0, 4.0]);
}

#[test]
fn columns_over_their_sums() {
    let module = ColumnsOverTheirSums::new(DMatrix::<f64>::from_column_slice(4, 5, &[-0.708, 0.36, -0.239, -1.14, -1.399, 0.42, -1.042, 0.687, 1.265, 0.552, -0.39, -0.798, -0.482, 0.706, -1.613, 1.496, 1.915, -1.397, 1.871, 0.649])).unwrap();
    check("y", &module.y(), &[2.8210350937200337, 1.7494996427550364, 2.7198152510786464, 2.251130826940096]);
    check("s", &module.s(), &[-1.7269999999999999, -1.3339999999999999, 0.629, 0.10699999999999998, 3.0380000000000003]);
    check("B", &module.B(), &[0.40995946728430804, -0.20845396641574987, 0.13839027214823393, 0.6601042269832079, 1.0487256371814093, -0.3148425787106447, 0.7811094452773615, -0.514992503748126, 2.011128775834658, 0.87758346581876, -0.6200317965023847, -1.2686804451510334, -4.504672897196262, 6.598130841121496, -15.07476635514019, 13.981308411214956, 0.630348913759052, -0.45984200131665565, 0.6158657011191573, 0.21362738643844634]);
    check("z", &module.z(), &[-0.9890405327156919, 0.21154603358425011, -0.9036097278517661, 1.347104226983208]);
}

#[test]
fn weighted_covariance() {
    let module = WeightedCovariance::new(vec![DVec3::new(1.34, -0.66, 0.679), DVec3::new(-1.164, 0.207, 1.077), DVec3::new(-1.739, 0.911, -1.938), DVec3::new(1.833, -0.125, -0.364)], vec![1.494_f64, -1.283_f64, -1.455_f64, -1.547_f64]).unwrap();
    check("A", &module.A(), &[-5.00758638125761, -1.07714958851738, 2.5428931110053754, -1.07714958851738, 1.4000299751250453, -1.0326329553994995, 2.5428931110053754, -1.0326329553994995, -3.210988542474381]);
}

#[test]
fn vectorised_kronecker() {
    let module = VectorisedKronecker::new(DMat2::from_cols_array(&[1.669, 0.056, 0.517, -0.013]), DMat2::from_cols_array(&[-1.01, -1.23, -1.953, 0.768])).unwrap();
    check("y", &module.y(), &[-2.695391, -1.655814, -0.031171, -0.07886399999999999]);
    check("z", &module.z(), &[-2.6953910000000003, -1.655814, -0.031171, -0.07886399999999999]);
}

#[test]
fn appended_one() {
    let module = AppendedOne::new(DMatrix::<f64>::from_column_slice(4, 5, &[-0.708, 0.36, -0.239, -1.14, -1.399, 0.42, -1.042, 0.687, 1.265, 0.552, -0.39, -0.798, -0.482, 0.706, -1.613, 1.496, 1.915, -1.397, 1.871, 0.649]), DVector::<f64>::from_column_slice(&[1.494, -1.283, -1.455, -1.547])).unwrap();
    check("y", &module.y(), &[1.5572439999999999, -3.293362, 5.913581000000001, -3.0888029999999995]);
    check("z", &module.z(), &[1.5572439999999999, -3.293362, 5.913581000000001, -3.0888029999999995]);
}

#[test]
fn rotation_about_axis() {
    let module = RotationAboutAxis::new(DVec3::new(0.6, 0.0, 0.8), 0.7_f64).unwrap();
    check("R", &module.R(), &[0.8494989998620726, 0.5153741497901527, 0.11287575010344555, -0.5153741497901528, 0.7648421872844884, 0.3865306123426147, 0.11287575010344555, -0.3865306123426146, 0.9153431874224158]);
}

#[test]
fn difference_of_indices() {
    let module = DifferenceOfIndices::new(DVector::<f64>::from_column_slice(&[1.494, -1.283, -1.455, -1.547, 1.918, 1.766]), DVector::<f64>::from_column_slice(&[-1.077, 1.88, -1.169, 0.026, -0.01, 1.66]), SVector::<i64, 3>::new(3, 5, 1), DMat4::from_cols_array(&[11.003, -3.665, 3.585, 3.262, -3.665, 7.469, -2.673, -1.743, 3.585, -2.673, 9.533, 4.463, 3.262, -1.743, 4.463, 8.6])).unwrap();
    check("y", &module.y(), &[22.41751]);
    check("z", &module.z(), &[-2.6929999999999996]);
}

#[test]
fn integers_and_reals_in_sets() {
    let module = IntegersAndRealsInSets::new(Set::<i64>::from_iter([-4_i64, 2_i64, 5_i64])).unwrap();
    check("S", &module.S(), &[1.0, 2.0, 3.0, 4.0, 25.0]);
    check("y", &module.y(), &[34.0]);
    check("z", &module.z(), &[5.0]);
    check("R", &module.R(), &[]);
}

#[test]
fn sparse_stays_sparse() {
    let module = SparseStaysSparse::new(sparse(5, 5, &[(0, 0, 9.0), (0, 2, 0.498), (0, 3, 0.163), (0, 4, 4.489), (1, 1, 21.412), (1, 3, 0.104), (2, 0, 0.498), (2, 2, 9.0), (2, 3, 0.623), (3, 0, 0.163), (3, 1, 0.104), (3, 2, 0.623), (3, 3, 9.0), (3, 4, 7.482), (4, 0, 4.489), (4, 3, 7.482), (4, 4, 9.0)]), sparse(5, 5, &[(0, 2, -0.494), (0, 3, 0.549), (0, 4, -0.967), (1, 0, -0.094), (1, 1, 0.099), (1, 2, 0.524), (1, 4, 1.848), (2, 0, -0.843), (2, 1, -0.776), (2, 2, -0.975), (2, 4, -0.308), (3, 0, 1.087), (3, 1, 0.838), (3, 2, -1.218), (3, 3, -1.452), (3, 4, -0.714), (4, 0, 1.073), (4, 1, -0.048), (4, 3, 0.626)]), DMatrix::<f64>::from_column_slice(5, 5, &[13.914, 1.72, -1.661, -4.641, 1.417, 1.72, 11.257, -3.451, 3.467, 6.046, -1.661, -3.451, 8.616, -1.985, -4.013, -4.641, 3.467, -1.985, 13.767, 4.423, 1.417, 6.046, -4.013, 4.423, 13.699]), DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("C", &module.C(), &[101.425694, 0.016952, 9.065549, 36.830952, 82.02156599999999, 0.016952, 458.48455999999993, 0.064792, 3.162848, 0.7781279999999999, 9.065549, 0.064792, 81.636133, 11.295174, 6.896808, 36.830952, 3.162848, 11.295174, 137.40583800000002, 135.40770700000002, 82.02156599999999, 0.7781279999999999, 6.896808, 135.40770700000002, 157.13144499999999]);
    check("D", &module.D(), &[-0.0, -0.0, -0.41981399999999996, 0.177181, 4.816697, 0.0, 2.119788, -0.0, 0.087152, -0.0, -0.246012, 0.0, -8.775, -0.758814, 0.0, 0.08948700000000001, -0.0, -0.0, -13.068, 4.683732, -4.340863, 0.0, -0.0, -5.342148, 0.0]);
    check("E", &module.E(), &[9.0, -0.094, -0.345, 1.25, 5.561999999999999, 0.0, 21.511, -0.776, 0.942, -0.048, 0.0040000000000000036, 0.524, 8.025, -0.595, 0.0, 0.7120000000000001, 0.104, 0.623, 7.548, 8.108, 3.522, 1.848, -0.308, 6.768000000000001, 9.0]);
    check("F", &module.F(), &[125.226, 0.0, -0.827178, -0.756483, 6.360913, 0.0, 241.03488399999998, -0.0, 0.360568, 0.0, -0.827178, -0.0, 77.544, -1.236655, -0.0, -0.756483, 0.360568, -1.236655, 123.90299999999999, 33.092886, 6.360913, 0.0, -0.0, 33.092886, 123.291]);
    check("H", &module.H(), &[1291.5441443519999, 4.381395231999999, 156.731619708, 965.1719129690001, 1466.91721723, 4.193395232, 9817.202334911997, 4.1140244, 80.337108528, 30.839678264, 156.033619708, 1.5140243999999998, 748.2267338040001, 208.03821717, 187.277013329, 966.247912969, 82.01310852799998, 205.60221717, 2266.046280544, 2410.8219864440002, 1470.99721723, 27.047678263999998, 187.893013329, 2413.501986444, 2795.4982785479997]);
    check("y", &module.y(), &[50.52002409, 443.8041674479999, -126.18564080900002, 32.06026405500001, 62.546467348]);
    check("s", &module.s(), &[9416.887955933229]);
}

#[test]
fn sparse_solves() {
    let module = SparseSolves::new(sparse(5, 5, &[(0, 0, 9.0), (0, 2, 0.498), (0, 3, 0.163), (0, 4, 4.489), (1, 1, 21.412), (1, 3, 0.104), (2, 0, 0.498), (2, 2, 9.0), (2, 3, 0.623), (3, 0, 0.163), (3, 1, 0.104), (3, 2, 0.623), (3, 3, 9.0), (3, 4, 7.482), (4, 0, 4.489), (4, 3, 7.482), (4, 4, 9.0)]), DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031]), DMatrix::<f64>::from_column_slice(5, 5, &[13.914, 1.72, -1.661, -4.641, 1.417, 1.72, 11.257, -3.451, 3.467, 6.046, -1.661, -3.451, 8.616, -1.985, -4.013, -4.641, 3.467, -1.985, 13.767, 4.423, 1.417, 6.046, -4.013, 4.423, 13.699])).unwrap();
    check("y", &module.y(), &[0.9656559337688407, 0.08326767020023454, -0.5170977674954829, 1.4526215930055584, -1.682371582839546]);
    check("X", &module.X(), &[2.905256293843586, 0.07188633455300154, -0.46563314338258716, 1.7381711976070278, -2.7366324892844043, -1.4661799817276306, 0.5375517037140254, -0.13388145896716594, -2.4332411531222258, 3.425910249515092, 0.44244921166656254, -0.16537063812053507, 0.8730031388762591, 0.8645779176624715, -1.3853251656802013, 3.3738083674777726, 0.1222154086096235, -0.97308048067139, 8.174266065872517, -7.986876051829544, -7.060419136256953, 0.3394466595479372, 0.7583030828598386, -11.752229560004148, 14.813711452289834]);
    check("z", &module.z(), &[0.8263941499629595]);
}

#[test]
fn norms_with_powers() {
    let module = NormsWithPowers::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031]), 1.5_f64, DMatrix::<f64>::from_column_slice(5, 4, &[-0.708, -1.399, 1.265, -0.482, 1.915, 0.36, 0.42, 0.552, 0.706, -1.397, -0.239, -1.042, -0.39, -1.613, 1.871, -1.14, 0.687, -0.798, 1.496, 0.649]), DMatrix::<f64>::from_column_slice(5, 5, &[13.914, 1.72, -1.661, -4.641, 1.417, 1.72, 11.257, -3.451, 3.467, 6.046, -1.661, -3.451, 8.616, -1.985, -4.013, -4.641, 3.467, -1.985, 13.767, 4.423, 1.417, 6.046, -4.013, 4.423, 13.699])).unwrap();
    check("y", &module.y(), &[90.13780344613366]);
}

#[test]
fn callbacks_of_sequences() {
    let module = CallbacksOfSequences::new(|u: DVec3, t: f64| u.x * t + u.z, vec![DVec3::new(1.34, -0.66, 0.679), DVec3::new(-1.164, 0.207, 1.077), DVec3::new(-1.739, 0.911, -1.938), DVec3::new(1.833, -0.125, -0.364)], 1.5_f64).unwrap();
    check("y", &module.y(), &[-0.14100000000000001]);
    check("z", &module.z(), &[2.019, -1.251, -7.155, 6.968]);
}

#[test]
fn function_of_two_subscripts_and_a_vector() {
    let module = FunctionOfTwoSubscriptsAndAVector::new(DVec4::new(1.494, -1.283, -1.455, -1.547)).unwrap();
    check("y", &module.y(), &[-2.223807]);
}

#[test]
fn products_over_indices() {
    let module = ProductsOverIndices::new(DVector::<f64>::from_column_slice(&[1.494, -1.283, -1.455, -1.547, 1.918, 1.766]), DVector::<f64>::from_column_slice(&[-1.077, 1.88, -1.169, 0.026, -0.01, 1.66]), 0.3_f64).unwrap();
    check("y", &module.y(), &[14225.654140067283]);
    check("z", &module.z(), &[11.390510968101719]);
}

#[test]
fn least_of_everything() {
    let module = LeastOfEverything::new(1.5_f64, -0.75_f64, DVector::<f64>::from_column_slice(&[1.494, -1.283, -1.455, -1.547, 1.918, 1.766]), DMatrix::<f64>::from_column_slice(6, 6, &[-1.838, 1.523, 0.726, 1.678, -1.634, 0.811, -0.739, 1.044, 0.943, 0.387, 1.862, 0.575, 0.4, 1.316, -0.793, -0.682, 0.302, 1.802, -1.734, 1.044, -1.329, 1.747, 1.215, -0.266, -1.054, 0.831, 1.026, -1.379, -0.872, -0.34, -0.14, 1.399, -1.337, 0.058, 1.207, 0.768])).unwrap();
    check("y", &module.y(), &[4.159]);
}

#[test]
fn halves_of_integers() {
    let module = HalvesOfIntegers::new(7_i64).unwrap();
    check("y", &module.y(), &[4.0]);
    check("k", &module.k(), &[6.0]);
    check("z", &module.z(), &[3.0]);
}

#[test]
fn sequences_as_vectors() {
    let module = SequencesAsVectors::new(DMatrix::<f64>::from_column_slice(5, 5, &[13.914, 1.72, -1.661, -4.641, 1.417, 1.72, 11.257, -3.451, 3.467, 6.046, -1.661, -3.451, 8.616, -1.985, -4.013, -4.641, 3.467, -1.985, 13.767, 4.423, 1.417, 6.046, -4.013, 4.423, 13.699]), vec![1.494_f64, -1.283_f64, -1.455_f64, -1.547_f64, 1.918_f64], DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("y", &module.y(), &[30.894944, -0.6190669999999975, -15.216319999999998, -21.307874999999996, 19.631196000000003]);
    check("z", &module.z(), &[0.04953708261662905, -0.2669120377159903, -0.18429288319905762, -0.1326195281011712, 0.24151872154732285]);
    check("t", &module.t(), &[40.404028488]);
    check("d", &module.d(), &[-0.9349999999999999, 2.25, -0.17899999999999983, 1.712, -1.887]);
}

#[test]
fn pairs_of_a_set() {
    let module = PairsOfASet::new(Set::<(i64, i64)>::from_iter([(1_i64, 2_i64), (3_i64, 1_i64), (2_i64, 5_i64)]), DVector::<f64>::from_column_slice(&[1.494, -1.283, -1.455, -1.547, 1.918, 1.766]), DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031])).unwrap();
    check("y", &module.y(), &[0.59158]);
    check("z", &module.z(), &[0.59158]);
    check("c", &module.c(), &[2.0]);
}

#[test]
fn degrees_and_laplacian() {
    let module = DegreesAndLaplacian::new(Set::<(i64, i64)>::from_iter([(0_i64, 1_i64), (1_i64, 0_i64), (1_i64, 2_i64), (2_i64, 1_i64), (0_i64, 3_i64), (3_i64, 0_i64)]), DVector::<f64>::from_column_slice(&[1.494, -1.283, -1.455, -1.547])).unwrap();
    check("d", &module.d(), &[2.0, 2.0, 1.0, 1.0]);
    check("L", &module.L(), &[2.0, -1.0, 0.0, -1.0, -1.0, 2.0, -1.0, 0.0, 0.0, -1.0, 1.0, 0.0, -1.0, 0.0, 0.0, 1.0]);
    check("q", &module.q(), &[16.988994]);
}

#[test]
fn projection_out_of() {
    let module = ProjectionOutOf::new(DVector::<f64>::from_column_slice(&[0.559, 0.967, -1.634, 0.165, 0.031]), DVector::<f64>::from_column_slice(&[1.485, -0.555, 0.393, -1.763, -0.449]), DMatrix::<f64>::from_column_slice(5, 5, &[13.914, 1.72, -1.661, -4.641, 1.417, 1.72, 11.257, -3.451, 3.467, 6.046, -1.661, -3.451, 8.616, -1.985, -4.013, -4.641, 3.467, -1.985, 13.767, 4.423, 1.417, 6.046, -4.013, 4.423, 13.699])).unwrap();
    check("v", &module.v(), &[1.577589680645724, -0.3948314468972901, 0.12235324118942292, -1.7356703089328365, -0.4438653307691996]);
    check("c", &module.c(), &[116.63131745186872]);
}

#[test]
fn columns_by_assignment() {
    let module = ColumnsByAssignment::new(DVec3::new(-1.198, -0.522, -1.985), DVec3::new(1.32, -1.382, -0.93)).unwrap();
    check("A", &module.A(), &[-1.198, -0.522, -1.985, 1.32, -1.382, -0.93]);
    check("G", &module.G(), &[5.647913, 0.986094, 0.986094, 4.517224]);
}

#[test]
fn locals_of_locals() {
    let module = LocalsOfLocals::new(vec![1.494_f64, -1.283_f64, -1.455_f64, -1.547_f64, 1.918_f64, 1.766_f64]).unwrap();
    check("y", &module.y(), &[24.357999999999997]);
}

#[test]
fn moving_average() {
    let module = MovingAverage::new(DVector::<f64>::from_column_slice(&[1.494, -1.283, -1.455, -1.547, 1.918, 1.766]), 1_i64, DVector::<f64>::from_column_slice(&[-1.077, 1.88, -1.169, 0.026, -0.01, 1.66])).unwrap();
    check("y", &module.y(), &[0.5683333333333334, -0.4146666666666667, -1.4283333333333335, -0.3613333333333333, 0.7123333333333334, 1.8166666666666667]);
}

#[test]
fn blocks_with_multiples_of_identities() {
    let module = BlocksWithMultiplesOfIdentities::new(DMat2::from_cols_array(&[1.669, 0.056, 0.517, -0.013]), 1.5_f64, sparse(5, 5, &[(0, 0, 13.914), (0, 1, 1.72), (0, 2, -1.661), (0, 3, -4.641), (0, 4, 1.417), (1, 0, 1.72), (1, 1, 11.257), (1, 2, -3.451), (1, 3, 3.467), (1, 4, 6.046), (2, 0, -1.661), (2, 1, -3.451), (2, 2, 8.616), (2, 3, -1.985), (2, 4, -4.013), (3, 0, -4.641), (3, 1, 3.467), (3, 2, -1.985), (3, 3, 13.767), (3, 4, 4.423), (4, 0, 1.417), (4, 1, 6.046), (4, 2, -4.013), (4, 3, 4.423), (4, 4, 13.699)])).unwrap();
    check("C", &module.C(), &[1.669, 0.056, -3.0, -0.0, 0.517, -0.013, -0.0, -3.0, -1.0, -0.0, 1.669, 0.517, -0.0, -1.0, 0.056, -0.013]);
    check("D", &module.D(), &[1.669, 0.056, 1.0, 0.0, 0.517, -0.013, 0.0, 1.0, 1.5, 0.0, 0.0, 0.0, 0.0, 1.5, 0.0, 0.0]);
    check("E", &module.E(), &[1.0, -1.0]);
    check("F", &module.F(), &[13.914, 1.72, -1.661, -4.641, 1.417, -1.5, -0.0, -0.0, -0.0, -0.0, 1.72, 11.257, -3.451, 3.467, 6.046, -0.0, -1.5, -0.0, -0.0, -0.0, -1.661, -3.451, 8.616, -1.985, -4.013, -0.0, -0.0, -1.5, -0.0, -0.0, -4.641, 3.467, -1.985, 13.767, 4.423, -0.0, -0.0, -0.0, -1.5, -0.0, 1.417, 6.046, -4.013, 4.423, 13.699, -0.0, -0.0, -0.0, -0.0, -1.5, -1.0, -0.0, -0.0, -0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, -1.0, -0.0, -0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, -0.0, -1.0, -0.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, -0.0, -0.0, -1.0, -0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.0, -0.0, -0.0, -0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
}

}
