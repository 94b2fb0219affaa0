plugins {
    id("com.android.application")
}

android {
    namespace = "io.github.glideslam.sample"
    compileSdk = 36

    defaultConfig {
        applicationId = "io.github.glideslam.sample"
        minSdk = 26
        targetSdk = 36
        versionCode = 1
        versionName = "0.1.0"
    }

    buildTypes {
        release {
            isMinifyEnabled = true
            proguardFiles(getDefaultProguardFile("proguard-android-optimize.txt"))
        }
    }

    compileOptions {
        sourceCompatibility = JavaVersion.VERSION_1_8
        targetCompatibility = JavaVersion.VERSION_1_8
    }
}

dependencies {
    implementation(project(":glide-slam"))
}
